using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingFinderTests : WingFinderFixture
    {
        [Test]
        public void NamesAlone_AreEnough_InAnyHierarchy()
        {
            // No two of these are mirror images, so that only their names tell them.
            m_Insect.Draw("Model/Body", m_Insect.Body());
            m_Insect.Draw("Model/Bones/Chest/HindWing_L", Wing(-1f, s_Hind, 0.9f));
            m_Insect.Draw("Model/Bones/Chest/Left_forewing.001", Wing(-1f, s_Fore, 1f));
            m_Insect.Draw("Model/HindWing_R", Wing(1f, s_Hind, 0.6f));
            m_Insect.Draw("Model/right_forewing", Wing(1f, s_Fore, 1.4f));

            AssertFound(
                "right_forewing Fore Right WholeMesh", "Left_forewing.001 Fore Left WholeMesh",
                "HindWing_R Hind Right WholeMesh", "HindWing_L Hind Left WholeMesh");
        }

        [Test]
        public void Symmetry_IsEnough_WhereNoNameTells()
        {
            m_Insect.Draw("Cube", m_Insect.Body());
            m_Insect.Draw("Plane", Wing(-1f, s_Fore, 1f));
            m_Insect.Draw("Plane.001", Wing(1f, s_Fore, 1f));
            foreach (float side in new[] { 1f, -1f })
            {
                m_Insect.Draw("Sphere" + side, new MeshSketch().Box(new Vector3(0.1f * side, 0f, 0.4f), 0.1f * Vector3.one));
                m_Insect.Draw("Leg" + side, new MeshSketch().Box(new Vector3(0.5f * side, 0f, 0f), new Vector3(1f, 0.04f, 0.04f)));
            }

            AssertFound("Plane.001 Fore Right WholeMesh", "Plane Fore Left WholeMesh");
        }

        [Test]
        public void FourMirroredSheets_AreForeAndHind_ByTheirOrderAlongTheBody()
        {
            m_Insect.Draw("a", Wing(1f, s_Hind, 0.8f));
            m_Insect.Draw("b", Wing(-1f, s_Fore, 1f));
            m_Insect.Draw("c", Wing(-1f, s_Hind, 0.8f));
            m_Insect.Draw("d", Wing(1f, s_Fore, 1f));

            AssertFound("d Fore Right WholeMesh", "b Fore Left WholeMesh", "a Hind Right WholeMesh", "c Hind Left WholeMesh");
        }

        [TestCase("Wing")]
        [TestCase("Plane")]
        public void ANegativeScale_PutsAWingOnTheOtherSide(string name)
        {
            Mesh mesh = m_Insect.Draw(name + "A", Wing(1f, s_Fore, 1f)).GetComponent<MeshFilter>().sharedMesh;
            MeshRenderer mirrored = m_Insect.Draw("Mirror/" + name + "B", new MeshSketch());
            mirrored.GetComponent<MeshFilter>().sharedMesh = mesh;
            m_Insect.Place("Mirror").localScale = new Vector3(-1f, 1f, 1f);

            AssertFound($"{name}A Fore Right WholeMesh", $"{name}B Fore Left WholeMesh");
        }

        [Test]
        public void WherePlaceAndNameDisagree_ThePlaceCounts()
        {
            m_Insect.Draw("Wing_L", Wing(1f, s_Fore, 1f));
            m_Insect.Draw("Wing_R", Wing(-1f, s_Fore, 1f));

            AssertFound("Wing_L Fore Right WholeMesh", "Wing_R Fore Left WholeMesh");
        }

        [Test]
        public void ClosedWings_AreToldApart_ThoughTheyTouchInTheMiddle()
        {
            foreach (float side in new[] { 1f, -1f })
            {
                var corner = new Vector3(0.01f * side, 0f, 0.5f);
                m_Insect.Draw("Plane" + side, new MeshSketch().Sheet(corner, new Vector3(0.1f * side, 1f, 0f), Vector3.back));
            }

            AssertFound("Plane1 Fore Right WholeMesh", "Plane-1 Fore Left WholeMesh");
        }

        [Test]
        public void AModelThatIsTurnedAndScaledInside_IsSeenFromTheRoot()
        {
            // As imported from a program with Z up and centimetres.
            Transform model = m_Insect.Place("Model");
            model.localRotation = Quaternion.Euler(-90f, 0f, 0f);
            model.localScale = 0.01f * Vector3.one;
            Matrix4x4 back = Matrix4x4.TRS(Vector3.zero, model.localRotation, model.localScale).inverse;
            foreach (float side in new[] { 1f, -1f })
            {
                foreach (Vector3 hinge in new[] { s_Hind, s_Fore })
                {
                    MeshSketch wing = Wing(side, hinge, 1f);
                    for (int vertex = 0; vertex < wing.positions.Count; vertex++)
                        wing.positions[vertex] = back.MultiplyPoint3x4(wing.positions[vertex]);
                    m_Insect.Draw($"Model/{(hinge == s_Fore ? "F" : "H")}{side}", wing);
                }
            }

            AssertFound("F1 Fore Right WholeMesh", "F-1 Fore Left WholeMesh", "H1 Hind Right WholeMesh", "H-1 Hind Left WholeMesh");
        }

        [Test]
        public void ASmallHindWing_BelowTheRearOfABroadForeWing_IsAWingOfItsOwn()
        {
            foreach (float side in new[] { 1f, -1f })
            {
                MeshSketch fore = new MeshSketch().Sheet(Side(s_Fore, side), side * Vector3.right, Vector3.back);
                Vector3 below = Side(s_Fore + new Vector3(0.1f, -0.1f, -0.6f), side);
                m_Insect.Draw("a" + side, new MeshSketch().Sheet(below, 0.6f * side * Vector3.right, 0.35f * Vector3.back));
                m_Insect.Draw("b" + side, fore);
            }

            AssertFound("b1 Fore Right WholeMesh", "b-1 Fore Left WholeMesh", "a1 Hind Right WholeMesh", "a-1 Hind Left WholeMesh");
        }

        [Test]
        public void SheetsThatAreNoMirrorImages_AreNoWings()
        {
            m_Insect.Draw("right", Wing(1f, s_Fore, 1f));
            m_Insect.Draw("behind", Wing(-1f, s_Fore + Vector3.back, 1f));
            m_Insect.Draw("larger", Wing(-1f, s_Fore, 1.5f));

            AssertFound();
        }

        [Test]
        public void VeinsOverAMembrane_AreTheSamePairAsIt()
        {
            foreach (float side in new[] { 1f, -1f })
            {
                m_Insect.Draw("Wing membrane" + side, Wing(side, s_Fore, 1f));
                m_Insect.Draw("Wing veins" + side, Wing(side, s_Fore + new Vector3(0.02f, 0.01f, -0.02f), 0.95f));
            }

            Assert.That(WingFinder.Find(m_Insect.Root).Select(wing => wing.Pair), Is.EqualTo(new WingPair[4]));
        }

        [Test]
        public void TheOnlyPair_IsTheForePair_WhateverItsName()
        {
            m_Insect.Draw("elytron.R", Wing(1f, s_Fore, 1f));
            m_Insect.Draw("elytron.L", Wing(-1f, s_Fore, 1f));
            m_Insect.Draw("hindwing.R", Wing(1f, s_Hind, 1f));
            m_Insect.Draw("hindwing.L", Wing(-1f, s_Hind, 1f));

            AssertFound("hindwing.R Fore Right WholeMesh", "hindwing.L Fore Left WholeMesh");
        }

        [Test]
        public void Elytra_AreNoWings_EvenWhereOnlyTheirShapeCouldTell()
        {
            m_Insect.Draw("elytra/R", Wing(1f, s_Fore, 1f));
            m_Insect.Draw("elytra/L", Wing(-1f, s_Fore, 1f));

            AssertFound();
        }

        [Test]
        public void FinsOfAFish_AreFound_ButNotItsTail()
        {
            m_Insect.Draw("Fin Right", Wing(1f, s_Fore, 0.4f));
            m_Insect.Draw("Fin Left", Wing(-1f, s_Fore, 0.4f));
            m_Insect.Draw("Tail Fin", new MeshSketch().Sheet(Vector3.back, Vector3.back, Vector3.up));

            AssertFound("Fin Right Fore Right WholeMesh", "Fin Left Fore Left WholeMesh");
        }

        [Test]
        public void HiddenChildren_CountOnlyWhereNothingElseDoes()
        {
            m_Insect.Draw("Wing_R", Wing(1f, s_Fore, 1f));
            m_Insect.Draw("Wing_L", Wing(-1f, s_Fore, 1f));
            MeshRenderer hidden = m_Insect.Draw("Variant/Wing_R2", Wing(1f, s_Fore, 1.2f));
            m_Insect.Place("Variant").gameObject.SetActive(false);
            MeshRenderer disabled = m_Insect.Draw("Wing_L2", Wing(-1f, s_Fore, 1.2f));
            disabled.enabled = false;
            m_Insect.Root.gameObject.SetActive(false);

            AssertFound("Wing_R Fore Right WholeMesh", "Wing_L Fore Left WholeMesh");

            m_Insect.Place("Wing_R").gameObject.SetActive(false);
            m_Insect.Place("Wing_L").gameObject.SetActive(false);
            Assert.That(WingFinder.Find(m_Insect.Root).Select(wing => wing.Renderer), Is.SupersetOf(new[] { hidden, disabled }));
        }

        [Test]
        public void OfLevelsOfDetail_OnlyTheHighestCounts()
        {
            var levels = new List<LOD>();
            for (int level = 0; level < 3; level++)
            {
                MeshRenderer right = m_Insect.Draw($"Wing_R_LOD{level}", Wing(1f, s_Fore, 1f));
                MeshRenderer left = m_Insect.Draw($"Wing_L_LOD{level}", Wing(-1f, s_Fore, 1f));
                levels.Add(new LOD(0.5f / (level + 1), new Renderer[] { right, left, null }));
            }

            m_Insect.Root.gameObject.AddComponent<LODGroup>().SetLODs(levels.ToArray());

            AssertFound("Wing_R_LOD0 Fore Right WholeMesh", "Wing_L_LOD0 Fore Left WholeMesh");
        }

        [Test]
        public void TheWingsOfEverySpecies_AreFound_WithoutNames()
        {
            foreach (InsectDefinition species in InsectCatalogue.All)
            {
                // Without names the firefly's open elytra, thin and mirrored, cannot be told from wings.
                if (species.Name == "firefly")
                    continue;
                using var insect = new InsectSketch();
                insect.Draw("0", species.Body.CreateSurface(InsectDefinition.UnitsPerMetre));
                var expected = new List<string>();
                for (int pair = 0; pair < species.Wings.Count; pair++)
                {
                    foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
                    {
                        WingDefinition wing = species.Wings[pair];
                        insect.Draw($"{pair} {side}", wing.CreateSurface(side)).transform.localPosition = wing.HingeOn(side);
                        expected.Add($"{pair} {side} {(WingPair)pair} {side}");
                    }
                }

                List<string> found = WingFinder.Find(insect.Root).ConvertAll(wing => $"{wing.Renderer.name} {wing.Pair} {wing.Side}");
                Assert.That(found, Is.EqualTo(expected), species.Name);
            }
        }

        [Test]
        public void NothingLikeAWing_GivesAnEmptyList()
        {
            m_Insect.Draw("Body", m_Insect.Body());
            m_Insect.Draw("Swing", new MeshSketch().Box(Vector3.right, Vector3.one));
            m_Insect.Draw("Ground", new MeshSketch().Sheet(new Vector3(-5f, 0f, -5f), 10f * Vector3.right, 10f * Vector3.forward));
            m_Insect.Draw("OneSidedSign", new MeshSketch().Sheet(Vector3.right, Vector3.right, Vector3.forward));
            m_Insect.Draw("Wing empty", new MeshSketch());
            m_Insect.Place("Wing without anything");
            m_Insect.Place("Wing without mesh").gameObject.AddComponent<MeshRenderer>();

            AssertFound();
            Assert.That(WingFinder.FindSkinned(m_Insect.Root), Is.Empty);
            Assert.That(() => WingFinder.Find(null), Throws.ArgumentNullException);
        }

        [Test]
        public void AnObjectWithScaleZero_BreaksNothing()
        {
            m_Insect.Draw("Wing_R", Wing(1f, s_Fore, 1f));
            m_Insect.Draw("Wing_L", Wing(-1f, s_Fore, 1f));
            m_Insect.Root.localScale = Vector3.zero;

            Assert.That(() => WingFinder.Find(m_Insect.Root), Throws.Nothing);
        }
    }
}
