using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Equality of the inspected and the baked rig.</summary>
    public sealed class RigInspectionTests : EditingFixture
    {
        private const int k_Patches = 256;

        [Test]
        public void WeightsMassesAndPatches_AreThoseOfTheBakedRig()
        {
            RigInspection seen = Inspect();
            var rig = WingRig.Bake(Skeleton, Surface(), new WingRigSettings { patchCount = k_Patches });
            try
            {
                Assert.That(seen.masses, Is.EqualTo(rig.JointMasses.ToArray()));
                Assert.That(seen.PatchCount, Is.EqualTo(rig.PatchCount));
                for (int vertex = 0; vertex < rig.VertexCount; vertex++)
                {
                    for (int corner = 0; corner < 4; corner++)
                    {
                        JointIndex joint = seen.Joint(rig.VertexJoints[vertex][corner]);
                        Assert.That(seen.Weight(vertex, new[] { joint }), Is.EqualTo(rig.VertexWeights[vertex][corner]).Within(1e-6f));
                    }
                }
            }
            finally
            {
                rig.Release();
            }
        }

        [Test]
        public void AllJointsTogether_MoveEveryVertexEntirely()
        {
            RigInspection seen = Inspect();
            JointIndex[] all = JointPicking.All(Skeleton).ToArray();

            for (int vertex = 0; vertex < seen.points.Length; vertex += 7)
                Assert.That(seen.Weight(vertex, all), Is.EqualTo(1f).Within(1e-6f));
        }

        [Test]
        public void WeightColours_AreLightAtTheSelectedJoint_AndDarkFarFromIt()
        {
            RigInspection seen = Inspect();
            var joint = new JointIndex(2, 2);
            Color32[] colours = RigColouring.Corners(seen, RigColourMode.JointWeight, new[] { joint }, WingParameters.Default);

            int near = Corner(seen, Skeleton.GetJoint(2, 2)), far = Corner(seen, Skeleton.GetJoint(0, 4));

            Assert.That(Brightness(colours[near]), Is.GreaterThan(Brightness(RigColouring.Ramp(0.8f))));
            Assert.That(colours[far], Is.EqualTo(RigColouring.Ramp(0f)));
        }

        [Test]
        public void DelayColours_GrowFromTheLeadingToTheTrailingEdge()
        {
            RigInspection seen = Inspect();
            Color32[] colours = RigColouring.Corners(seen, RigColourMode.Delay, new JointIndex[0], WingParameters.Default);

            float[] across = Enumerable.Range(0, 5).Select(i => Brightness(colours[Corner(seen, Skeleton.GetJoint(i, 2))])).ToArray();

            Assert.That(across, Is.Ordered);
            Assert.That(across[4] - across[0], Is.GreaterThan(0.2f));
        }

        [Test]
        public void DelayLegend_NamesTheLargestDelay()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.chordDelay = 0.5f;
            parameters.spanDelay = 0.1f;

            Assert.That(RigColouring.Legend(Inspect(), RigColourMode.Delay, parameters), Is.EqualTo(("0°", "108° of the beat")));
        }

        [Test]
        public void MassLegend_NamesTheHeaviestJoint_AndOthersTheirEnds()
        {
            RigInspection seen = Inspect();
            string most = System.FormattableString.Invariant($"{100f * seen.masses.Max():0.#} % of the mass");

            Assert.That(RigColouring.Legend(seen, RigColourMode.JointMass, WingParameters.Default), Is.EqualTo(("0", most)));
            Assert.That(RigColouring.Legend(seen, RigColourMode.JointWeight, WingParameters.Default), Is.EqualTo(("0", "1")));
            Assert.That(most, Is.Not.EqualTo("0 % of the mass"));
        }

        [Test]
        public void MassColours_ReachTheirEnd_AtTheHeaviestJoint()
        {
            RigInspection seen = Inspect();
            Color32[] colours = RigColouring.Corners(seen, RigColourMode.JointMass, new JointIndex[0], WingParameters.Default);
            int heaviest = System.Array.IndexOf(seen.masses, seen.masses.Max());

            int corner = Corner(seen, seen.frame.ToMesh(seen.rest.joints[heaviest]));

            Assert.That(Brightness(colours[corner]), Is.GreaterThan(Brightness(RigColouring.Ramp(0.8f))));
        }

        [Test]
        public void PatchColours_AreOneForEachPatch()
        {
            RigInspection seen = Inspect();
            Color32[] colours = RigColouring.Corners(seen, RigColourMode.Patch, new JointIndex[0], WingParameters.Default);

            for (int t = 0; t < seen.triangles.Count; t++)
            {
                Assert.That(colours[3 * t], Is.EqualTo(colours[3 * t + 1]).And.EqualTo(colours[3 * t + 2]));
                int other = System.Array.IndexOf(seen.patches, seen.patches[t]);
                Assert.That(colours[3 * t], Is.EqualTo(colours[3 * other]));
            }

            Assert.That(seen.patches.Distinct().Count(), Is.EqualTo(seen.PatchCount));
        }

        [Test]
        public void Ramp_GetsLighterAllTheWay()
        {
            float[] brightness = Enumerable.Range(0, 101).Select(k => Brightness(RigColouring.Ramp(k / 100f))).ToArray();

            Assert.That(brightness, Is.Ordered);
        }

        [Test]
        public void DrawnMesh_CoversTheWing_AndFollowsTheSelection()
        {
            var mesh = new InspectionMesh();
            RigInspection seen = Inspect();
            mesh.Show(seen, RigColourMode.JointWeight, new[] { new JointIndex(0, 4) }, WingParameters.Default);
            Color32[] first = mesh.Mesh.colors32;
            Mesh drawn = mesh.Mesh;

            mesh.Show(seen, RigColourMode.JointWeight, new[] { new JointIndex(4, 4) }, WingParameters.Default);

            Assert.That(mesh.Mesh, Is.SameAs(drawn));
            Assert.That(drawn.colors32, Is.Not.EqualTo(first));
            AssertShows(drawn, seen);
            var other = RigInspection.TryMake(Skeleton, Stretched(2f), k_Patches, out _);
            mesh.Show(other, RigColourMode.JointWeight, new[] { new JointIndex(4, 4) }, WingParameters.Default);
            Assert.That(mesh.Mesh, Is.SameAs(drawn));
            AssertShows(drawn, other);
            mesh.Dispose();
            Assert.That(mesh.Mesh == null, "none is shown");
            Assert.That(drawn == null, "destroyed");
        }

        [Test]
        public void AMeshThatWasFreed_IsDrawnAgain_OfTheSameWing()
        {
            var mesh = new InspectionMesh();
            RigInspection seen = Inspect();
            mesh.Show(seen, RigColourMode.Patch, new JointIndex[0], WingParameters.Default);
            mesh.Dispose();
            mesh.Show(seen, RigColourMode.Patch, new JointIndex[0], WingParameters.Default);
            AssertShows(mesh.Mesh, seen);
            Assert.That(mesh.Mesh.colors32, Is.EqualTo(
                RigColouring.Corners(seen, RigColourMode.Patch, new JointIndex[0], WingParameters.Default)));
            Assert.That(mesh.Mesh.hideFlags, Is.EqualTo(HideFlags.HideAndDontSave));
            mesh.Dispose();
        }

        [Test]
        public void InvalidSkeleton_AndBrokenMesh_SayWhyThereIsNothingToSee()
        {
            SurfaceMesh broken = Surface();
            broken.triangles = new[] { 0, 1, 999999 };
            Assert.That(RigInspection.TryMake(Skeleton, broken, 0, out string mesh), Is.Null);
            Assert.That(mesh, Does.Contain("refers to vertex 999999"));

            Do("Reverse Chains");
            Assert.That(RigInspection.TryMake(Skeleton, Surface(), 0, out string skeleton), Is.Null);
            Assert.That(skeleton, Is.EqualTo(Skeleton.Validate()[0].Message));
        }

        private SurfaceMesh Stretched(float by)
        {
            SurfaceMesh surface = Surface();
            surface.positions = surface.positions.Select(place => by * place).ToArray();
            return surface;
        }

        // Each corner of each triangle on its own, where the wing has it.
        private static void AssertShows(Mesh drawn, RigInspection seen)
        {
            Vector3[] places = drawn.vertices;
            int[] corners = drawn.triangles;
            Assert.That(places, Has.Length.EqualTo(3 * seen.triangles.Count));
            Assert.That(corners.Distinct().Count(), Is.EqualTo(places.Length), "corners share nothing");
            for (int k = 0; k < corners.Length; k++)
                Assert.That(places[corners[k]], Is.EqualTo(seen.Surface.positions[seen.triangles.corners[k / 3][k % 3]]));
        }

        private RigInspection Inspect() => RigInspection.TryMake(Skeleton, Surface(), k_Patches, out _);

        private static int Corner(RigInspection seen, Vector3 place)
        {
            int best = 0;
            float least = float.PositiveInfinity;
            for (int corner = 0; corner < 3 * seen.triangles.Count; corner++)
            {
                float distance = Vector3.Distance(seen.Surface.positions[seen.triangles.corners[corner / 3][corner % 3]], place);
                if (distance >= least)
                    continue;
                least = distance;
                best = corner;
            }

            return best;
        }

        private static float Brightness(Color32 colour) => (0.3f * colour.r + 0.59f * colour.g + 0.11f * colour.b) / 255f;
    }
}
