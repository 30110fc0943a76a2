using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class BeatPreviewTests : EditingFixture
    {
        private BeatPreview m_Preview;

        [SetUp]
        public void Make() => m_Preview = new BeatPreview();

        [TearDown]
        public void Dispose() => m_Preview.Dispose();

        [Test]
        public void Picture_ShowsTheWantedPhase([Values(0f, 0.13f, 0.5f, 0.99f)] float phase)
        {
            Bake();
            m_Preview.Show(phase);

            float off = Mathf.Repeat(m_Preview.Phase - phase + 0.5f, 1f) - 0.5f;
            Assert.That(off, Is.EqualTo(0f).Within(2e-3f));
        }

        [Test]
        public void WingIsUp_AtTheStartOfTheBeat_AndDown_HalfABeatLater()
        {
            Bake();
            m_Preview.Show(0f);
            float up = TipHeight();
            m_Preview.Show(0.5f);

            Assert.That(up, Is.GreaterThan(0.2f));
            Assert.That(TipHeight(), Is.LessThan(-0.1f));
        }

        [Test]
        public void SamePhaseABeatLater_IsTheSamePicture()
        {
            Bake();
            m_Preview.Show(0.3f);
            Vector3[] first = m_Preview.Mesh.vertices;
            m_Preview.Show(0.7f);
            m_Preview.Show(0.3f);

            float most = first.Zip(m_Preview.Mesh.vertices, (a, b) => Vector3.Distance(a, b)).Max();
            Assert.That(most, Is.LessThan(0.03f * 0.61f), "settled to three per cent of the span");
        }

        [Test]
        public void EditedSkeleton_ChangesThePicture()
        {
            Bake();
            m_Preview.Show(0.25f);
            Vector3[] before = m_Preview.Mesh.vertices;

            Select((2, 4), (3, 4));
            Editing.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, new Vector3(-0.05f, 0f, 0f)));
            Bake();
            m_Preview.Show(0.25f);

            Assert.That(before.Zip(m_Preview.Mesh.vertices, (a, b) => Vector3.Distance(a, b)).Max(), Is.GreaterThan(1e-3f));
        }

        [Test]
        public void InvalidSkeleton_LeavesNoPicture_AndSaysWhy_UntilItIsMended()
        {
            Do("Reverse Chains");
            Bake();

            Assert.That(m_Preview.IsReady, Is.False);
            Assert.That(m_Preview.Mesh, Is.Null);
            Assert.That(m_Preview.Problem, Does.StartWith("Skeleton 'Right Wing' cannot be used: Chain 0"));
            Assert.That(() => m_Preview.Show(0.5f), Throws.Nothing);

            Undo.Undo();
            Bake();
            Assert.That(m_Preview.Problem, Is.Null);
            Assert.That(m_Preview.IsReady);
        }

        [Test]
        public void APictureThatIsShown_GoesWithASkeletonThatIsInvalid_AndWithThePreview()
        {
            Bake();
            m_Preview.Show(0.5f);
            Do("Reverse Chains");
            Bake();
            Assert.That((m_Preview.IsReady, m_Preview.Mesh == null), Is.EqualTo((false, true)));
            Assert.That(() => m_Preview.Show(0.5f), Throws.Nothing);

            Undo.Undo();
            Bake();
            Mesh shown = m_Preview.Mesh;
            m_Preview.Dispose();
            Assert.That((m_Preview.IsReady, m_Preview.Mesh == null, shown == null), Is.EqualTo((false, true, true)));
            Assert.That(() => m_Preview.Dispose(), Throws.Nothing);
            Bake();
            m_Preview.Show(0.5f);
            Assert.That(TipHeight(), Is.LessThan(-0.1f));
        }

        [Test]
        public void APicture_HasTheTrianglesOfTheWing_UnitNormals_AndBoundsThatHoldIt()
        {
            Bake();
            m_Preview.Show(0.25f);
            Mesh mesh = m_Preview.Mesh;
            Assert.That(mesh.triangles, Is.EqualTo(Surface().triangles));
            Assert.That(mesh.vertexCount, Is.EqualTo(Surface().positions.Length));
            Assert.That(mesh.normals, Is.All.Matches<Vector3>(normal => Mathf.Abs(normal.magnitude - 1f) < 1e-2f));
            Bounds bounds = mesh.bounds;
            bounds.Expand(1e-4f);
            Assert.That(mesh.vertices, Is.All.Matches<Vector3>(place => bounds.Contains(place)));
            var tight = new Bounds(mesh.vertices[0], Vector3.zero);
            foreach (Vector3 place in mesh.vertices)
                tight.Encapsulate(place);
            Assert.That(bounds.size.magnitude, Is.LessThan(1.3f * tight.size.magnitude));
            Assert.That((mesh.hideFlags, mesh.indexFormat), Is.EqualTo((HideFlags.HideAndDontSave,
                UnityEngine.Rendering.IndexFormat.UInt16)));
        }

        [Test]
        public void Flight_IsLevel_AtACruisingShareOfThePresetsSpeed()
        {
            var monarch = new PresetValues(null);

            var flight = PreviewFlight.Of(monarch);

            Assert.That(flight.surroundings.speed, Is.EqualTo(0.65f * monarch.parameters.maxSpeed).Within(1e-5f));
            Assert.That(-flight.surroundings.wind.z * monarch.size.wingLength, Is.EqualTo(flight.surroundings.speed).Within(1e-5f));
            Assert.That(
                -flight.surroundings.gravity.y * monarch.size.wingLength, Is.EqualTo(9.81f * monarch.size.gravityShare).Within(1e-4f));
        }

        private void Bake() => m_Preview.Bake(Skeleton, Surface(), PreviewFlight.Of(new PresetValues(null)));

        private float TipHeight()
        {
            Vector3[] vertices = m_Preview.Mesh.vertices, rest = Surface().positions;
            int tip = System.Array.FindIndex(rest, p => p.x >= rest.Max(q => q.x));
            return vertices[tip].y;
        }
    }
}
