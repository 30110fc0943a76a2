using System.Collections;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Edits while the wings beat take effect at once, and rebuild only the necessary parts.</summary>
    public sealed class LiveEditTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator AnEditedSpecies_IsSeenAtTheNextStep_WithoutRebuilding()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(30);
            Mesh living = Shown(insect, 0);
            float tall = 0f, flat = 0f;
            yield return Height(insect, value => tall = value);

            preset.Beat.flapRange = 30f;
            yield return Frames(30);
            yield return Height(insect, value => flat = value);

            Assert.That(Shown(insect, 0), Is.SameAs(living));
            Assert.That(insect.FlapRange, Is.EqualTo(0.5f * 30f).Within(0.01f));
            Assert.That(flat, Is.LessThan(0.5f * tall));
        }

        [UnityTest]
        public IEnumerator AnEditedSpecies_IsSeenByAllThatShareIt_AndByNoOthers()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            InsectWings first = Hatch(made => made.Preset = preset), second = Hatch(made => made.Preset = preset), other = Hatch();
            yield return Frames(10);
            preset.Beat.maxFrequency = 40f;
            yield return Frames(30);

            Assert.That(first.Frequency, Is.EqualTo(32f).Within(0.01f));
            Assert.That(second.Frequency, Is.EqualTo(32f).Within(0.01f));
            Assert.That(other.Frequency, Is.EqualTo(8.8f).Within(0.01f));
        }

        [UnityTest]
        public IEnumerator AnEditedSpecies_IsSeen_ThoughAnotherInsectWasSteppedManyTimes()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            InsectWings insect = Hatch(made => made.Preset = preset), stepped = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            yield return Frames(5);
            for (int step = 0; step < 200; step++)
                stepped.Step(0.001f);
            preset.Beat.maxFrequency = 40f;
            yield return Frames(30);

            Assert.That(insect.Frequency, Is.EqualTo(32f).Within(0.01f));
        }

        [UnityTest]
        public IEnumerator AnotherSpecies_IsFollowedInPhase_WithoutRebuilding([Values] bool ofWing, [Values] bool paper)
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            if (paper)
                preset.ApplyReading(ModelReading.Paper);
            preset.Beat.maxFrequency = 20f;
            preset.Beat.frequencyFloor = 1f;
            InsectWings insect = Hatch();
            yield return Frames(20);
            Mesh living = Shown(insect, 0);
            float beats = Beats(insect);

            if (ofWing)
                insect.Wings[0].Preset = preset;
            else
                insect.Preset = preset;
            yield return null;
            Assert.That(Beats(insect), Is.GreaterThanOrEqualTo(beats), "the beat started over");
            yield return Frames(20);

            Assert.That(Shown(insect, 0), Is.SameAs(living));
            Assert.That(insect.Read(0).Frequency, Is.EqualTo(20f).Within(0.01f));
            Assert.That(insect.Read(1).Frequency, Is.EqualTo(ofWing ? 8.8f : 20f).Within(0.01f));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ASpeciesOfNonsense_IsClamped()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(10);
            preset.Beat.maxFrequency = float.NaN;
            preset.Beat.flapRange = 1e9f;
            preset.Stiffness.elasticity = -5f;
            preset.Size.wingLength = 0f;
            preset.Size.wingMass = float.NaN;
            insect.Quality.substepsPerBeat = -7;
            insect.Quality.patches = -1;
            insect.Motion.metresPerUnit = float.NaN;
            insect.Motion.teleportDistance = float.NaN;
            insect.Air.wind = new Vector3(0f, float.NaN, 0f);
            yield return Frames(30);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
            foreach (Vector3 vertex in Shown(insect, 0).vertices)
                Assert.That(vertex.sqrMagnitude, Is.LessThan(4f));
        }

        [UnityTest]
        public IEnumerator ADestroyedSpecies_LeavesTheBeatAsItWas()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            preset.Beat.maxFrequency = 20f;
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(10);
            Object.DestroyImmediate(preset);
            yield return Frames(20);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(insect.Frequency, Is.EqualTo(16f).Within(0.01f));
        }

        [UnityTest]
        public IEnumerator AmplitudeScaleAndPhaseLead_AreSeen_WithoutRebuilding()
        {
            InsectWings insect = Hatch();
            yield return Frames(20);
            Mesh living = Shown(insect, 0);
            insect.Wings[0].AmplitudeScale = 0f;
            insect.Wings[1].PhaseLead = 90f;
            yield return Frames(60);
            float right = 0f, left = 0f;
            yield return Height(insect, value => right = value);
            yield return Height(insect, value => left = value, 1);

            Assert.That(Shown(insect, 0), Is.SameAs(living));
            Assert.That(right, Is.LessThan(0.1f));
            Assert.That(left, Is.GreaterThan(0.5f));
        }

        [UnityTest]
        public IEnumerator AnotherMesh_IsTakenOver_AndTheOldOneForgotten()
        {
            Mesh other = Keep(TestWings.ToMesh(TestWings.Ellipse(10, 8)));
            InsectWings insect = Hatch();
            yield return Frames(10);
            Filter(insect, 0).sharedMesh = other;
            yield return Frames(3);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Shown(insect, 0), Is.Not.SameAs(other));
            Assert.That(Shown(insect, 0).vertexCount, Is.EqualTo(other.vertexCount));
            insect.enabled = false;
            Assert.That(Shown(insect, 0), Is.SameAs(other));
            Assert.That(Shown(insect, 1), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator ADuplicateOfTheLivingMesh_IsNotTakenForTheWing()
        {
            InsectWings insect = Hatch(), twin = Hatch();
            yield return Frames(20);
            // Whoever reads MeshFilter.mesh has Unity make and show a duplicate.
            Mesh duplicate = Keep(Filter(insect, 0).mesh);
            yield return Frames(3);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Shown(insect, 0), Is.Not.SameAs(duplicate));
            Assert.That(Farthest(Joints(insect, 0), Joints(twin, 0)), Is.LessThan(0.2f));
            insect.enabled = false;
            Assert.That(Shown(insect, 0), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator AMeshGivenInTheFrameOfTheEnd_Stays()
        {
            Mesh other = Keep(TestWings.ToMesh(TestWings.Ellipse(10, 8)));
            InsectWings insect = Hatch();
            yield return Frames(10);
            Filter(insect, 0).sharedMesh = other;
            insect.enabled = false;

            Assert.That(Shown(insect, 0), Is.SameAs(other));
            yield return Frames(2);
        }

        [UnityTest]
        public IEnumerator AChangeOfOneWing_LeavesTheOtherAlone_AndInPhase(
            [Values("mesh", "skeleton", "edited skeleton", "measured skeleton", "renderer")] string what)
        {
            WingSkeleton own = Keep(TestWings.Fan());
            InsectWings insect = Hatch(made => made.Wings[0].Skeleton = own), twin = Hatch();
            yield return Frames(40);
            Mesh other = Shown(insect, 1), changed = Shown(insect, 0);

            switch (what)
            {
                case "mesh": Filter(insect, 0).sharedMesh = Keep(TestWings.ToMesh(TestWings.Ellipse(10, 8))); break;
                case "skeleton": insect.Wings[0].Skeleton = Keep(TestWings.Fan(4, 4)); break;
                case "edited skeleton": own.Chains[2].joints[2].z -= 0.01f; break;
                case "measured skeleton": own.Chains[2].flexuralStiffness = new[] { 1e-6f }; break;
                default: insect.Wings[0].Renderer = MakeWing(insect.transform, WingSide.Right).Renderer; break;
            }

            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Shown(insect, 0), Is.Not.SameAs(changed));
            Assert.That(Shown(insect, 1), Is.SameAs(other), "the other wing was rebuilt");
            Assert.That(Farthest(Joints(insect, 1), Joints(twin, 1)), Is.LessThan(1e-5f));
            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(1e-3f), "the wing began its beat over");
        }

        [UnityTest]
        public IEnumerator AWingMoreOrLess_IsFollowed_InPhase()
        {
            InsectWings insect = Hatch(), twin = Hatch();
            yield return Frames(20);
            Mesh first = Shown(insect, 0);
            insect.Wings.Add(MakeWing(insect.transform, WingSide.Right));
            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Shown(insect, 2), Is.Not.SameAs(WingMesh));
            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(1e-3f));
            Assert.That(Farthest(Joints(insect, 2), Joints(twin, 0)), Is.LessThan(0.2f));

            MeshFilter gone = Filter(insect, 1);
            insect.Wings.RemoveAt(1);
            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(gone.sharedMesh, Is.SameAs(WingMesh));
            Assert.That(Shown(insect, 0), Is.SameAs(first));

            insect.Wings.Reverse();
            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(insect.Read(1).Beats, Is.EqualTo(twin.Read(0).Beats));
            Assert.That(() => insect.Read(2), Throws.TypeOf<System.ArgumentOutOfRangeException>());
        }

        [UnityTest]
        public IEnumerator AnotherNumberOfPatches_IsFollowed()
        {
            InsectWings insect = Hatch();
            yield return Frames(10);
            insect.Quality.patches = 64;
            yield return Frames(3);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(insect.Read(0).PatchCount, Is.LessThanOrEqualTo(64));
            Assert.That(insect.Read(0).PatchCount, Is.GreaterThan(32));
        }

        private static IEnumerator Height(InsectWings insect, System.Action<float> tell, int wing = 0)
        {
            float lowest = 0f, highest = 0f;
            for (int frame = 0; frame < 14; frame++)
            {
                yield return null;
                float y = insect.Read(wing).JointPosition(0, 4).y;
                lowest = frame == 0 ? y : math.min(lowest, y);
                highest = frame == 0 ? y : math.max(highest, y);
            }

            tell(highest - lowest);
        }
    }
}
