using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>An insect that cannot live says why, once, troubles nobody, and lives as soon as it is mended.</summary>
    public sealed class StateTests : FlockFixture
    {
        /// <summary>A way to break an insect, and to mend it.</summary>
        public sealed class Fault
        {
            public InsectState state;
            public string thing, remedy;
            internal Action<StateTests, InsectWings> breaks, mends;

            public override string ToString() => state.ToString();
        }

        private static readonly Fault[] s_Faults =
        {
            new Fault
            {
                state = InsectState.NoWings, thing = "patient", remedy = "Add them",
                breaks = (_, insect) => TakeWings(insect),
                mends = (test, insect) => insect.Wings.Add(test.MakeWing(insect.transform, WingSide.Right)),
            },
            new Fault
            {
                state = InsectState.SkinnedWings, thing = "skin of the wings", remedy = "Convert",
                breaks = (_, insect) =>
                {
                    TakeWings(insect);
                    var skin = new GameObject("skin of the wings");
                    skin.transform.SetParent(insect.transform, false);
                    skin.AddComponent<SkinnedMeshRenderer>();
                },
                mends = (test, insect) => insect.Wings.Add(test.MakeWing(insect.transform, WingSide.Right)),
            },
            new Fault
            {
                state = InsectState.NoRenderer, thing = "patient", remedy = "Assign the MeshRenderer",
                breaks = (_, insect) => insect.Wings[1].Renderer = null,
                mends = (test, insect) => insect.Wings[1].Renderer = test.MakeWing(insect.transform, WingSide.Left).Renderer,
            },
            new Fault
            {
                state = InsectState.NoMesh, thing = "wing Left", remedy = "Add one",
                breaks = (_, insect) => Filter(insect, 1).sharedMesh = null,
                mends = (test, insect) => Filter(insect, 1).sharedMesh = test.WingMesh,
            },
            new Fault
            {
                state = InsectState.MeshNotReadable, thing = "wing Left", remedy = "Read/Write",
                breaks = (test, insect) => Filter(insect, 1).sharedMesh = test.SealedMesh(),
                mends = (test, insect) => Filter(insect, 1).sharedMesh = test.WingMesh,
            },
            new Fault
            {
                state = InsectState.NoSuchPart, thing = "Ellipse", remedy = "Choose one from 0 to 0",
                breaks = (_, insect) => TakeSubmesh(insect.Wings[1], 3),
                mends = (_, insect) => insect.Wings[1].Submesh = 0,
            },
            new Fault
            {
                state = InsectState.WingsOverlap, thing = "Ellipse", remedy = "Give each a part",
                breaks = (_, insect) => insect.Wings[1].Renderer = insect.Wings[0].Renderer,
                mends = (test, insect) => insect.Wings[1].Renderer = test.MakeWing(insect.transform, WingSide.Left).Renderer,
            },
            new Fault
            {
                state = InsectState.NoSkeleton, thing = "point", remedy = "Make a Wing Skeleton",
                breaks = (test, insect) =>
                {
                    Filter(insect, 1).sharedMesh = test.Keep(Specimens.NoWing("point"));
                    insect.Wings[1].Skeleton = null;
                },
                mends = (test, insect) =>
                {
                    Filter(insect, 1).sharedMesh = test.WingMesh;
                    insect.Wings[1].Skeleton = test.Skeleton;
                },
            },
            new Fault
            {
                state = InsectState.SkeletonInvalid, thing = "crooked", remedy = "Mend it",
                breaks = (test, insect) => insect.Wings[1].Skeleton = test.CrookedSkeleton(),
                mends = (test, insect) => insect.Wings[1].Skeleton.Chains = test.Skeleton.Chains,
            },
            new Fault
            {
                state = InsectState.SkeletonDoesNotFit, thing = "Ellipse", remedy = "Assign the skeleton",
                breaks = (test, insect) => insect.Wings[1].Skeleton = test.Keep(TestWings.Fan(5, 5, 10f, 5f)),
                mends = (test, insect) => insect.Wings[1].Skeleton = test.Skeleton,
            },
        };

        // The list and what it could be filled from again.
        private static void TakeWings(InsectWings insect)
        {
            foreach (Wing wing in insect.Wings)
                UnityEngine.Object.DestroyImmediate(wing.Renderer.gameObject);
            insect.Wings.Clear();
        }

        private static readonly string[] s_NoWings = { "empty", "lines", "needle", "point" };

        private readonly List<string> m_Warnings = new List<string>();

        [SetUp]
        public void Listen()
        {
            m_Warnings.Clear();
            Application.logMessageReceived += Hear;
        }

        [TearDown]
        public void StopListening() => Application.logMessageReceived -= Hear;

        [UnityTest]
        public IEnumerator AFault_IsNamedOnce_AndTroublesNobodyElse([ValueSource(nameof(s_Faults))] Fault fault)
        {
            InsectWings healthy = Hatch();
            LogAssert.Expect(LogType.Warning, new Regex(Regex.Escape(fault.thing) + ".*" + Regex.Escape(fault.remedy)));
            InsectWings patient = Hatch(insect => fault.breaks(this, insect), "patient");
            InsectWings later = Hatch();
            yield return Frames(10);

            Assert.That(patient.State, Is.EqualTo(fault.state), patient.Problem.Message);
            Assert.That(patient.Problem.Message, Does.Contain(fault.thing).And.Contain(fault.remedy));
            Assert.That(m_Warnings, Has.Count.EqualTo(1));
            Assert.That(m_Warnings[0], Does.Contain("patient"), "the message does not say which insect");
            Assert.That(healthy.State, Is.EqualTo(InsectState.Ready));
            Assert.That(later.State, Is.EqualTo(InsectState.Ready));
            float before = Beats(later);
            yield return Frames(10);
            Assert.That(Beats(later), Is.GreaterThan(before + 0.5f));
        }

        [UnityTest]
        public IEnumerator AMendedInsect_LivesByItself([ValueSource(nameof(s_Faults))] Fault fault)
        {
            InsectWings patient = Hatch(insect => fault.breaks(this, insect), "patient");
            yield return Frames(2);
            Assert.That(patient.State, Is.EqualTo(fault.state));

            fault.mends(this, patient);
            yield return Frames(3);

            Assert.That(patient.State, Is.EqualTo(InsectState.Ready), patient.Problem.Message);
            float before = Beats(patient);
            yield return Frames(10);
            Assert.That(Beats(patient), Is.GreaterThan(before + 0.5f));
            Assert.That(m_Warnings, Has.Count.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator AnInsectThatBreaksWhileItLives_SaysSo_AndComesBack([ValueSource(nameof(s_Faults))] Fault fault)
        {
            InsectWings healthy = Hatch(), patient = Hatch(null, "patient");
            yield return Frames(5);
            Assert.That(patient.State, Is.EqualTo(InsectState.Ready));

            fault.breaks(this, patient);
            yield return Frames(5);
            Assert.That(patient.State, Is.EqualTo(fault.state));
            Assert.That(healthy.State, Is.EqualTo(InsectState.Ready));

            fault.mends(this, patient);
            yield return Frames(3);
            Assert.That(patient.State, Is.EqualTo(InsectState.Ready), patient.Problem.Message);
        }

        [UnityTest]
        public IEnumerator ABrokenInsect_KeepsItsAuthoredMeshes()
        {
            InsectWings patient = Hatch(insect => insect.Wings[1].Renderer = null);
            yield return Frames(3);

            Assert.That(Shown(patient, 0), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator AnInsect_IsInactive_ThenWaiting_ThenReady()
        {
            InsectWings insect = Hatch(made => made.enabled = false);
            Assert.That(insect.State, Is.EqualTo(InsectState.Inactive));

            insect.enabled = true;
            Assert.That(insect.State, Is.EqualTo(InsectState.Waiting));

            yield return Frames(2);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AScaleOfZero_IsSaid_AndForgottenWhenItGrowsAgain()
        {
            InsectWings insect = Hatch(null, "patient");
            yield return Frames(5);

            insect.transform.localScale = Vector3.zero;
            yield return Frames(20);
            Assert.That(insect.State, Is.EqualTo(InsectState.ZeroScale));
            Assert.That(insect.Problem.Message, Does.Contain("patient").And.Contain("scale"));
            Assert.That(m_Warnings, Has.Count.EqualTo(1));

            insect.transform.localScale = Vector3.one;
            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator AnInsectBornWithoutSize_LivesWhenItHasOne()
        {
            InsectWings insect = Hatch(made => made.transform.localScale = Vector3.zero);
            yield return Frames(5);
            Assert.That(insect.State, Is.EqualTo(InsectState.ZeroScale));

            insect.transform.localScale = Vector3.one;
            yield return Frames(30);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator NumbersOfAnInsectThatDoesNotLive_AreZero_AndItsStateCannotBeRead()
        {
            InsectWings insect = Hatch(made => made.Wings[1].Renderer = null);
            yield return Frames(3);

            Assert.That(insect.Frequency + insect.FlapRange + insect.Phase + insect.Lift + insect.Drag + insect.LiftOverWeight, Is.Zero);
            Assert.That(insect.AirForce, Is.EqualTo(Vector3.zero));
            Assert.That(insect.JointPosition(0, 0, 0), Is.EqualTo(Vector3.zero));
            Assert.That(insect.BoundsOf(1), Is.EqualTo(default(Bounds)));
            Assert.That(() => insect.Read(0), Throws.InvalidOperationException.With.Message.Contains("NoRenderer"));
            Assert.That(() => insect.Read(2), Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("2 wings"));
            Assert.That(() => insect.AirForceOf(-1), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [UnityTest]
        public IEnumerator OneRendererUnderTwoInsects_ObeysTheFirst_UntilItEnds()
        {
            InsectWings first = Hatch(null, "first");
            yield return Frames(3);
            InsectWings second = Hatch(insect => insect.Wings[1].Renderer = first.Wings[1].Renderer, "second");
            yield return Frames(3);

            Assert.That(first.State, Is.EqualTo(InsectState.Ready));
            Assert.That(second.State, Is.EqualTo(InsectState.WingsOverlap));
            Assert.That(second.Problem.Message, Does.Contain("'second', wing 1").And.Contain("another Insect Wings"));
            Mesh living = Shown(first, 1);
            yield return Frames(3);
            Assert.That(Shown(first, 1), Is.SameAs(living), "the two fight for the renderer");

            first.enabled = false;
            yield return Frames(3);
            Assert.That(second.State, Is.EqualTo(InsectState.Ready));
            second.enabled = false;
            Assert.That(Shown(second, 1), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator AMeshThatIsNoWing_BreaksItsOwnInsectOnly([ValueSource(nameof(s_NoWings))] string kind)
        {
            InsectWings patient = Hatch(insect => Filter(insect, 0).sharedMesh = Keep(Specimens.NoWing(kind)), "patient");
            InsectWings healthy = Hatch();
            yield return Frames(3);

            Assert.That(patient.State, Is.EqualTo(InsectState.NoSuchPart).Or.EqualTo(InsectState.SkeletonDoesNotFit));
            Assert.That(patient.Problem.Message, Does.Contain("patient").And.Contain(kind));
            Assert.That(m_Warnings, Has.Count.EqualTo(1));
            Assert.That(healthy.State, Is.EqualTo(InsectState.Ready));
        }

        private Mesh SealedMesh()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.UploadMeshData(true);
            return mesh;
        }

        private WingSkeleton CrookedSkeleton()
        {
            WingSkeleton skeleton = Keep(TestWings.Fan());
            skeleton.name = "crooked";
            skeleton.Chains = new[] { skeleton.Chains[0] };
            return skeleton;
        }

        private static void TakeSubmesh(Wing wing, int submesh)
        {
            wing.Part = WingPart.Submesh;
            wing.Submesh = submesh;
        }

        private void Hear(string text, string trace, LogType type)
        {
            if (type != LogType.Log)
                m_Warnings.Add(text);
        }

        [UnityTest]
        public IEnumerator AnErrorWhileItIsBuilt_IsToldOnce_AndTheMeshesComeBack()
        {
            InsectWings patient = Hatch(null, "patient");
            patient.enabled = false;
            var world = new WingWorld();
            world.Dispose();
            using var skins = new GpuSkins();
            var population = new InsectRegistry(
                world, new AssetWatch<WingPreset, PresetValues>(asset => new PresetValues(asset)), skins);
            LogAssert.Expect(LogType.Exception, new Regex("ObjectDisposedException"));
            LogAssert.Expect(LogType.Warning, new Regex("'patient'.*an error came up.*disable and enable"));

            population.Enter(patient);
            population.UpdateRegistry();
            population.UpdateRegistry();

            Assert.That(patient.State, Is.EqualTo(InsectState.Failed));
            Assert.That(patient.Problem.Message, Does.Contain("ObjectDisposedException").And.Contain("'patient'"));
            Assert.That(Shown(patient, 0), Is.SameAs(WingMesh));
            population.End();
            patient.enabled = true;
            yield return Frames(3);
            Assert.That(patient.State, Is.EqualTo(InsectState.Ready));
        }
    }
}
