using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Pictures over a wing: what they are of, when they are made anew, and when they go.</summary>
    public sealed class WingOverlayLaws : SkeletonSessionFixture
    {
        private static readonly JointIndex[] s_None = new JointIndex[0];

        private WingOverlay m_Overlay;

        [SetUp]
        public void Make() => m_Overlay = new WingOverlay();

        [TearDown]
        public void Free() => m_Overlay.Dispose();

        [Test]
        public void OfAWingWithoutAMesh_NothingIsShown_ThoughAnotherWasShownBefore_AndThatComesBack()
        {
            SkeletonTarget target = Target(Right);
            m_Overlay.ShowsBeat = true;
            m_Overlay.Colours = RigColourMode.Patch;
            m_Overlay.Refresh(target, s_None, hurries: false);
            Assert.That((m_Overlay.BeatMesh == null, m_Overlay.ColourMesh == null, m_Overlay.Rig == null),
                Is.EqualTo((false, false, false)));

            m_Overlay.Refresh(new SkeletonTarget(Left.Skeleton, null, null) { WithoutSurface = "No." }, s_None, hurries: false);
            Assert.That((m_Overlay.BeatMesh == null, m_Overlay.ColourMesh == null, m_Overlay.Rig == null), Is.EqualTo((true, true, true)));
            Assert.That(m_Overlay.Refusal, Is.EqualTo("No."));

            m_Overlay.Refresh(target, s_None, hurries: false);
            Assert.That((m_Overlay.BeatMesh == null, m_Overlay.ColourMesh == null, m_Overlay.Rig == null),
                Is.EqualTo((false, false, false)));
            Assert.That(m_Overlay.Refusal, Is.Null);
        }

        [Test]
        public void WhileADragHurries_TheRigIsInspectedForItsColoursOnly()
        {
            SkeletonTarget target = Target(Right);
            m_Overlay.Refresh(target, s_None, hurries: true);
            Assert.That(m_Overlay.Rig, Is.Null);
            m_Overlay.Refresh(target, s_None, hurries: false);
            RigInspection first = m_Overlay.Rig;
            Assert.That(first, Is.Not.Null);
            m_Overlay.Refresh(target, s_None, hurries: false);
            Assert.That(m_Overlay.Rig, Is.SameAs(first), "nothing has changed");

            Right.Skeleton.Chains[2].joints[3] += new Vector3(0.01f, 0f, 0f);
            m_Overlay.Refresh(target, s_None, hurries: true);
            Assert.That(m_Overlay.Rig, Is.SameAs(first));
            m_Overlay.Colours = RigColourMode.Patch;
            m_Overlay.Refresh(target, s_None, hurries: true);
            Assert.That(m_Overlay.Rig, Is.Not.SameAs(first));
        }

        [Test]
        public void Colours_AreThoseOfTheRig_ForEachModeAndSelection_AndThePresetsDelays()
        {
            SkeletonTarget target = Target(Right);
            target.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            foreach (RigColourMode mode in System.Enum.GetValues(typeof(RigColourMode)))
            {
                foreach (JointIndex[] selected in new[] { s_None, new[] { new JointIndex(1, 1) }, new[] { new JointIndex(3, 4) } })
                {
                    m_Overlay.Colours = mode;
                    m_Overlay.Refresh(target, selected, hurries: false);
                    Assert.That(m_Overlay.ColourMesh.colors32,
                        Is.EqualTo(RigColouring.Corners(m_Overlay.Rig, mode, selected, m_Overlay.Parameters)), $"{mode}");
                }
            }

            m_Overlay.Colours = RigColourMode.Delay;
            m_Overlay.Refresh(target, s_None, hurries: false);
            Color32[] before = m_Overlay.ColourMesh.colors32;
            target.Preset.Wave.spanDelay += 0.3f;
            m_Overlay.Refresh(target, s_None, hurries: false);
            Assert.That(m_Overlay.ColourMesh.colors32, Is.Not.EqualTo(before));
            Assert.That(m_Overlay.Parameters.spanDelay, Is.EqualTo(target.Preset.Wave.spanDelay));
            m_Overlay.Colours = null;
            Assert.That(m_Overlay.ColourMesh, Is.Null);
        }

        [Test]
        public void ABeat_IsBakedForItsWing_AndShownAtThePhase()
        {
            m_Overlay.ShowsBeat = true;
            m_Overlay.Phase = 0.5f;
            m_Overlay.Refresh(Target(Right), s_None, hurries: false);
            Vector3[] right = m_Overlay.BeatMesh.vertices;
            m_Overlay.Refresh(Target(Left), s_None, hurries: false);
            Vector3[] left = m_Overlay.BeatMesh.vertices;
            float apart = right.Zip(left, (a, b) => Vector3.Distance(a, new Vector3(-b.x, b.y, b.z))).Max();
            Assert.That(apart, Is.LessThan(1e-3f), "the other wing is the mirror image");
            m_Overlay.Phase = 0f;
            m_Overlay.Refresh(Target(Left), s_None, hurries: false);
            Assert.That(m_Overlay.BeatMesh.vertices.Zip(left, Vector3.Distance).Max(), Is.GreaterThan(0.1f));
            m_Overlay.ShowsBeat = false;
            Assert.That(m_Overlay.BeatMesh, Is.Null);
        }

        [Test]
        public void ASelection_IsShownAgain_AfterAnother_AndTheSameJointsInAnotherMode()
        {
            SkeletonTarget target = Target(Right);
            var key = new OverlayKey(target, 7u);
            JointIndex[] one = { new JointIndex(1, 2) }, two = { new JointIndex(2, 1) };
            OverlayKey shown = key.With(RigColourMode.Delay, one, 3);
            Assert.That(shown.Equals(key.With(RigColourMode.Delay, one, 3)), Is.True);
            Assert.That(shown.GetHashCode(), Is.EqualTo(key.With(RigColourMode.Delay, one, 3).GetHashCode()));
            OverlayKey[] others =
            {
                key.With(RigColourMode.Patch, one, 3), key.With(null, one, 3), key.With(RigColourMode.Delay, two, 3),
                key.With(RigColourMode.Delay, one, 4), new OverlayKey(target, 8u).With(RigColourMode.Delay, one, 3),
                new OverlayKey(Target(Left), 7u).With(RigColourMode.Delay, one, 3),
                key.With(RigColourMode.Delay, one.Concat(two).ToArray(), 3),
            };
            Assert.That(others.Any(other => shown.Equals(other) || shown.Equals((object)other)), Is.False);
        }

        private static SkeletonTarget Target(Wing wing) =>
            new SkeletonTarget(wing.Skeleton, InsectTargets.SurfaceOf(wing, out _), wing.Renderer.transform);
    }
}
