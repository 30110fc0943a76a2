using System.Collections;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Wings while they live: parameters they are stepped with, room they are given, and when they are built again.</summary>
    public sealed class LiveWingLaws : FlockFixture
    {
        [UnityTest]
        public IEnumerator AWing_IsSteppedWithItsPreset_ItsOwnSliders_AndTheInsects()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch()), own = Keep(InsectCatalogue.Monarch());
            own.Beat.maxFrequency = 7f;
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(2);
            var presets = new AssetWatch<WingPreset, PresetValues>(asset => new PresetValues(asset));
            LiveWing wing = insect.Live.wings[0];
            wing.values = null;
            insect.Wings[0].AmplitudeScale = 0.5f;
            insect.Wings[0].PhaseLead = 90f;
            insect.Steering.frequencyScale = 2f;
            insect.Quality.substepsPerBeat = 40;

            WingParameters plain = preset.ToParameters();
            Assert.That(Apply(0.5f, out WingParameters parameters), Is.True);
            Assert.That(wing.values, Is.SameAs(presets.Of(preset)));
            Assert.That(parameters.maxFrequency, Is.EqualTo(2f * plain.maxFrequency));
            Assert.That(
                parameters.amplitudeScale, Is.EqualTo(0.25f * plain.amplitudeScale).Within(1e-6f), "its own, and how far it has faded");
            Assert.That(parameters.phaseLead, Is.EqualTo(plain.phaseLead + 0.5f * math.PI).Within(1e-6f));
            Assert.That(parameters.substepsPerBeat, Is.EqualTo(40));
            Assert.That(Apply(0.5f, out parameters), Is.False, "nothing was changed");
            Assert.That(Apply(1f, out parameters), Is.True, "another fade");
            insect.Quality.substepsPerBeat = 41;
            Assert.That(Apply(1f, out parameters), Is.True, "other substeps");
            insect.Wings[0].AmplitudeScale = 0.6f;
            Assert.That(Apply(1f, out parameters), Is.True);
            insect.Wings[0].PhaseLead = 91f;
            Assert.That(Apply(1f, out parameters), Is.True);
            preset.Beat.maxFrequency = 9f;
            presets.Refresh();
            Assert.That(Apply(1f, out parameters), Is.True);
            Assert.That(parameters.maxFrequency, Is.EqualTo(18f));
            insect.Wings[0].Preset = own;
            Assert.That(Apply(1f, out parameters), Is.True);
            Assert.That(parameters.maxFrequency, Is.EqualTo(14f), "its own preset");
            Assert.That(Apply(1f, out parameters), Is.False);

            for (int round = 0; round < 700; round++)
                presets.EndRound();
            own.Beat.maxFrequency = 8f;
            presets.Refresh();
            Assert.That(Apply(1f, out parameters), Is.True, "a preset that was let go is read anew");
            Assert.That(parameters.maxFrequency, Is.EqualTo(16f));
            insect.Wings[0].Preset = null;
            insect.Preset = own;
            Assert.That(Apply(1f, out parameters), Is.True, "the insect's");
            bool Apply(float fade, out WingParameters made) => wing.ApplyParameters(presets, new InsectTuning(insect, fade), out made);
        }

        // Folded once for each share and each edit of the preset; let go where it is spread.
        [UnityTest]
        public IEnumerator AFoldedWing_IsFoldedAnew_WhenShareOrPresetChanges()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(3);
            WingWorld world = WingSystem.Loop.World;
            WingHandle wing = insect.Live.wings[0].handle;
            insect.Steering.fold = 1f;
            yield return Frames(2);
            float middle = preset.ToParameters().meanFlap;
            Assert.That(world.Drive(wing).meanFlap, Is.EqualTo(math.radians(preset.Rest.flap) - middle).Within(1e-5f));
            var others = new WingDrive { frequency = 3f };
            world.SetDrive(wing, others);
            yield return Frames(2);
            Assert.That(world.Drive(wing), Is.EqualTo(others), "nothing has changed");
            preset.Rest.flap = 30f;
            yield return Frames(2);
            Assert.That(world.Drive(wing).meanFlap, Is.EqualTo(math.radians(30f) - middle).Within(1e-5f));
            insect.Steering.fold = 0.5f;
            yield return Frames(2);
            Assert.That(world.Drive(wing).meanFlap, Is.EqualTo(0.5f * (math.radians(30f) - middle)).Within(1e-5f));
            insect.Steering.fold = 0f;
            yield return Frames(2);
            Assert.That(world.Drive(wing), Is.EqualTo(default(WingDrive)));
            world.SetDrive(wing, others);
            preset.Rest.flap = 40f;
            yield return Frames(2);
            Assert.That(world.Drive(wing), Is.EqualTo(others), "one that is spread is others' to drive");
        }

        // The box holds the whole mesh, and a ball about each hinge that reaches a tenth farther than the wing.
        [UnityTest]
        public IEnumerator TheBoxOfALivingMesh_HoldsItsWings_HoweverTheyBeat()
        {
            InsectWings insect = Hatch();
            yield return Frames(2);
            Mesh authored = WingMesh, living = Shown(insect, 0);
            float3 hinge = insect.Live.wings[0].rig.Frame.origin;
            float farthest = 0f;
            foreach (Vector3 vertex in authored.vertices)
                farthest = math.max(farthest, math.distance(hinge, vertex));
            Bounds expected = authored.bounds;
            expected.Encapsulate(new Bounds(hinge, 2.2f * farthest * Vector3.one));
            Assert.That((living.bounds.min - expected.min).magnitude + (living.bounds.max - expected.max).magnitude, Is.LessThan(1e-4f));
            Assert.That(Object.ReferenceEquals(LivingMeshes.SourceOf(living), authored));
            Assert.That(LivingMeshes.LivesOn(Filter(insect, 0)), Is.True);
        }

        // A registry of its own: what comes, changes or goes is told once.
        [UnityTest]
        public IEnumerator OnlyARoundInWhichSomethingWasBuilt_IsTold()
        {
            InsectWings insect = Hatch(made => made.enabled = false);
            yield return Frames(2);
            using (var world = new WingWorld())
            using (var skins = new GpuSkins())
            {
                var registry = new InsectRegistry(
                    world, new AssetWatch<WingPreset, PresetValues>(asset => new PresetValues(asset)), skins);
                Assert.That(registry.IsEmpty && !registry.UpdateRegistry());
                registry.Enter(insect);
                Assert.That(registry.IsEmpty, Is.False);
                Assert.That(registry.UpdateRegistry(), Is.True, "it comes");
                Assert.That(registry.Living, Has.Count.EqualTo(1));
                Assert.That(world.Count, Is.EqualTo(2));
                Assert.That(registry.UpdateRegistry(), Is.False, "nothing changes");
                insect.Quality.patches = 30;
                Assert.That(registry.UpdateRegistry(), Is.True, "it changes");
                Assert.That(registry.UpdateRegistry(), Is.False);
                insect.Wings.RemoveAt(1);
                Assert.That(registry.UpdateRegistry(), Is.True);
                Assert.That(world.Count, Is.EqualTo(1));
                registry.Leave(insect);
                Assert.That(registry.UpdateRegistry(), Is.False);
                Assert.That(registry.IsEmpty && world.Count == 0);
                registry.End();
            }
        }

        [Test]
        public void WhatIsMergedIntoAList_KeepsItsSettings_AndStrangersStay()
        {
            MeshRenderer a = Draw("a"), b = Draw("b"), c = Draw("c");
            var kept = new Wing { Renderer = a, Part = WingPart.Submesh, Submesh = 1, PhaseLead = 5f };
            var gone = new Wing { Renderer = a, Part = WingPart.Submesh, Submesh = 2 };
            var stranger = new Wing { Renderer = b };
            var found = new List<Wing>
            {
                new Wing { Renderer = a, Part = WingPart.Submesh, Submesh = 1 },
                new Wing { Renderer = c, Part = WingPart.ConnectedPart, Point = Vector3.one },
            };
            List<Wing> merged = WingList.Merge(new[] { gone, kept, null, new Wing(), stranger }, found);
            Assert.That(merged, Is.EqualTo(new[] { kept, found[1], stranger }));

            Assert.That(WingList.SamePart(kept, found[0]));
            Assert.That(WingList.SamePart(kept, gone) || WingList.SamePart(kept, null) || WingList.SamePart(null, kept), Is.False);
            var same = new Wing { Renderer = c, Part = WingPart.ConnectedPart, Point = Vector3.one };
            Assert.That(WingList.SamePart(found[1], same));
            same.Point = Vector3.up;
            Assert.That(WingList.SamePart(found[1], same), Is.False);
            Assert.That(WingList.SamePart(new Wing { Renderer = a, Submesh = 1 }, new Wing { Renderer = a, Point = Vector3.one }),
                "of whole meshes the renderer counts");
            Assert.That(WingList.SamePart(new Wing { Renderer = a }, new Wing { Renderer = b }), Is.False);
            Assert.That(WingList.SamePart(new Wing { Renderer = a }, kept), Is.False, "a mesh and a part of it");

            Wing[] list = { stranger, kept, new Wing { Renderer = b } };
            Assert.That((WingList.HasTwin(list, 0), WingList.HasTwin(list, 1), WingList.HasTwin(list, 2)), Is.EqualTo((true, false, true)));
            Assert.That(WingList.HasTwin(list, -1) || WingList.HasTwin(list, 3), Is.False);
        }

        private MeshRenderer Draw(string name) => Keep(new GameObject(name)).AddComponent<MeshRenderer>();
    }
}
