using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonSessionTests : SkeletonSessionFixture
    {
        private SnapshotUndo m_Undo;
        private SkeletonSession m_Session;

        [SetUp]
        public void Open()
        {
            m_Undo = new SnapshotUndo();
            m_Session = new SkeletonSession(InsectTargets.Find(new[] { Insect }), m_Undo);
        }

        [TearDown]
        public void Close() => m_Session.Dispose();

        [Test]
        public void Joints_FollowTheMovingInsect()
        {
            Insect.transform.position += 10f * Vector3.up;
            m_Session.Place();

            Assert.That(m_Session.Group.All[0].LocalToWorld, Is.EqualTo(Right.Renderer.transform.localToWorldMatrix));
        }

        [Test]
        public void SymmetricCommand_ChangesBothWings()
        {
            m_Session.IsSymmetric = true;
            m_Session.Place();
            m_Session.Select(m_Session.Group.All[0], new[] { new JointIndex(2, 2) });

            Assert.That(m_Session.Do(SkeletonCommands.Find("Add Joint Row")).Done);

            Assert.That(Right.Skeleton.JointsPerChain, Is.EqualTo(6));
            Assert.That(Left.Skeleton.JointsPerChain, Is.EqualTo(6));
        }

        [Test]
        public void Refusals_AreKept_UntilAnActIsDone()
        {
            m_Session.Do(SkeletonCommands.Find("Remove Chain"));
            Assert.That(m_Session.LastRefusal, Does.StartWith("Select a joint"));

            m_Session.Do(SkeletonCommands.Find("Fit Axes"));
            Assert.That(m_Session.LastRefusal, Is.Null);
        }

        [Test]
        public void Beat_IsShown_AndFollowsEdits()
        {
            Assert.That(m_Session.Overlay.BeatMesh, Is.Null);
            m_Session.Overlay.ShowsBeat = true;
            m_Session.Overlay.Phase = 0.25f;
            m_Session.Place();
            Vector3[] before = m_Session.Overlay.BeatMesh.vertices;

            m_Session.Place();
            Assert.That(m_Session.Overlay.BeatMesh.vertices, Is.EqualTo(before), "nothing has changed");

            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(3, 4), new JointIndex(2, 4) });
            m_Session.Group.Active.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, new Vector3(-0.06f, 0f, 0f)));
            m_Session.Place();

            Assert.That(m_Session.Overlay.BeatMesh.vertices, Is.Not.EqualTo(before));
        }

        [Test]
        public void Beat_FollowsThePreset()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            Insect.Preset = preset;
            m_Session.Dispose();
            m_Session = new SkeletonSession(InsectTargets.Find(new[] { Insect }), m_Undo);
            m_Session.Overlay.ShowsBeat = true;
            m_Session.Place();
            Vector3[] before = m_Session.Overlay.BeatMesh.vertices;

            preset.Beat.flapRange = 40f;
            m_Session.Place();

            Assert.That(m_Session.Overlay.BeatMesh.vertices, Is.Not.EqualTo(before));
        }

        [TestCase(float.NaN)]
        [TestCase(0f)]
        [TestCase(float.PositiveInfinity)]
        public void Beat_OfABrokenPreset_BreaksNothing(float number)
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            preset.Beat.maxSpeed = number;
            preset.Beat.flapRange = number;
            Insect.Preset = preset;
            m_Session.Dispose();
            m_Session = new SkeletonSession(InsectTargets.Find(new[] { Insect }), m_Undo);
            m_Session.Overlay.ShowsBeat = true;

            Assert.That(() => m_Session.Place(), Throws.Nothing);
            Assert.That(m_Session.Overlay.BeatMesh.vertices.All(place => !float.IsNaN(place.x + place.y + place.z)));
        }

        [Test]
        public void Colours_FollowTheSelection()
        {
            m_Session.Overlay.Colours = RigColourMode.JointWeight;
            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(0, 4) });
            m_Session.Place();
            Color32[] before = m_Session.Overlay.ColourMesh.colors32;

            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(4, 4) });
            m_Session.Place();

            Assert.That(m_Session.Overlay.ColourMesh.colors32, Is.Not.EqualTo(before));
        }

        [Test]
        public void Weaknesses_AppearAndVanish()
        {
            m_Session.Place();
            Assert.That(m_Session.Overlay.Problems, Is.Empty);

            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(0, 4), new JointIndex(0, 3) });
            m_Session.Group.Active.Do("Slide", (draft, selected) => SlideCommands.By(draft, selected, -0.15f));
            m_Session.Place();
            Assert.That(m_Session.Overlay.Problems.Select(p => p.Kind), Has.Member(RigProblemKind.FarVertices));

            m_Undo.Undo();
            m_Session.Place();
            Assert.That(m_Session.Overlay.Problems, Is.Empty);
        }

        [Test]
        public void WithoutItsMesh_TheWingHasNoWeaknessesEither()
        {
            m_Session.Group.Active.Do(
                "Slide", (draft, selected) => SlideCommands.By(draft, new[] { new JointIndex(0, 4), new JointIndex(0, 3) }, -0.15f));
            m_Session.Place();
            Assert.That(m_Session.Overlay.Problems, Is.Not.Empty);

            m_Session.Overlay.Refresh(new SkeletonTarget(Right.Skeleton, default, null), new JointIndex[0], hurries: false);

            Assert.That(m_Session.Overlay.Problems, Is.Empty);
            Assert.That(m_Session.Overlay.Refusal, Is.EqualTo("There is no mesh to show the rig on."));
        }

        [Test]
        public void UnreadableMesh_IsSaidToBeThat()
        {
            Right.Renderer.GetComponent<MeshFilter>().sharedMesh.UploadMeshData(true);
            m_Session.Dispose();
            m_Session = new SkeletonSession(InsectTargets.Find(new[] { Insect }), m_Undo);

            Assert.That(m_Session.Overlay.Refusal, Does.Contain("Read/Write"));
        }

        [Test]
        public void InvalidSkeleton_ShowsNothing_AndSaysWhy()
        {
            m_Session.Overlay.ShowsBeat = true;
            m_Session.Overlay.Colours = RigColourMode.Patch;
            m_Session.Do(SkeletonCommands.Find("Reverse Chains"));

            m_Session.Place();

            Assert.That(m_Session.Overlay.BeatMesh, Is.Null);
            Assert.That(m_Session.Overlay.ColourMesh, Is.Null);
            Assert.That(m_Session.Overlay.Refusal, Is.EqualTo(Right.Skeleton.Validate()[0].Message));
        }

        [Test]
        public void Framing_HoldsTheSelectedJoints_WithRoomAround()
        {
            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(0, 4) });
            Vector3 tip = Right.Renderer.transform.TransformPoint(Right.Skeleton.GetJoint(0, 4));

            Bounds one = m_Session.SelectedBounds();
            Assert.That(Vector3.Distance(one.center, tip), Is.LessThan(1e-4f));
            Assert.That(one.size.x, Is.GreaterThan(0.01f));

            m_Session.Group.Select(null, new JointIndex[0], adds: false);
            Bounds all = m_Session.SelectedBounds();
            Assert.That(all.Contains(tip));
            Assert.That(all.Contains(Left.Renderer.transform.TransformPoint(Left.Skeleton.GetJoint(4, 4))));
        }

        [Test]
        public void SessionIsStale_WhenASkeletonOrAWingIsGone()
        {
            Assert.That(m_Session.IsStale(), Is.False);
            Object.DestroyImmediate(Left.Renderer.gameObject);
            Assert.That(m_Session.IsStale());
            Assert.That(() => m_Session.Place(), Throws.Nothing);
        }

        [Test]
        public void ADragUnderWay_IsTakenBackWhenTheSessionEnds()
        {
            var eye = new View(new Vector3(3f, 9f, -2f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
            string before = SkeletonText.Of(Right.Skeleton);
            Vector2 from = eye.Project(Right.Renderer.transform.TransformPoint(Right.Skeleton.GetJoint(2, 2)));
            Vector2 to = from + new Vector2(60f, 20f);
            m_Session.Pointer.Press(eye.Project, from, false);
            m_Session.Pointer.Move(to, eye.Through(to), DragMode.WingPlane);
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.Not.EqualTo(before));

            m_Session.Dispose();

            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
            Assert.That(m_Session.Pointer.IsDown, Is.False);
        }

        [Test]
        public void AFrame_LeavesATwentiethOfTheLargestWing_OnEachSide()
        {
            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(0, 4), new JointIndex(0, 0) });
            Vector3 tip = World(Right, 0, 4), root = World(Right, 0, 0);
            float size = new[] { Right, Left }.Max(wing =>
            {
                var whole = new Bounds(World(wing, 0, 0), Vector3.zero);
                foreach (JointIndex joint in JointPicking.All(wing.Skeleton))
                    whole.Encapsulate(World(wing, joint.chain, joint.joint));
                return whole.size.magnitude;
            });
            Bounds framed = m_Session.SelectedBounds();
            Vector3 wanted = Vector3.Max(tip, root) - Vector3.Min(tip, root) + 0.1f * size * Vector3.one;
            Assert.That((framed.size - wanted).magnitude, Is.LessThan(1e-4f));
            Assert.That((framed.center - 0.5f * (tip + root)).magnitude, Is.LessThan(1e-4f));

            Vector3 World(Wing wing, int chain, int joint) => wing.Renderer.transform.TransformPoint(wing.Skeleton.GetJoint(chain, joint));
        }

        [Test]
        public void DestroyedSkeleton_MakesItStale_AndNothingBreaks()
        {
            Object.DestroyImmediate(Right.Skeleton);

            Assert.That(m_Session.IsStale());
            Assert.That(() => m_Session.Place(), Throws.Nothing);
        }
    }
}
