using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Vertices of living wings hold their way since the last picture, where the insect wants motion vectors.</summary>
    public sealed class MotionVectorTests : FlockFixture
    {
        private const int k_Channel = 5;

        /// <summary>Rounding of a half.</summary>
        private const float k_Half = 1f / 2048f;

        /// <summary>Smallest halves, and rounding of positions.</summary>
        private const float k_Least = 2e-7f;

        [UnityTest]
        public IEnumerator EachPicture_HoldsTheWaysSinceTheLast([Values] bool tangents)
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            if (tangents)
                mesh.tangents = System.Array.ConvertAll(mesh.vertices, _ => new Vector4(1f, 0f, 0f, -1f));
            InsectWings insect = Hatch(made =>
            {
                made.Quality.motionVectors = true;
                Filter(made, 0).sharedMesh = mesh;
            });
            yield return Frames(5);

            for (int frame = 0; frame < 20; frame++)
            {
                Vector3[] before = Shown(insect, 0).vertices;
                yield return null;
                AssertWays(Shown(insect, 0), before);
                Assert.That(Longest(insect), Is.GreaterThan(1e-3f));
            }
        }

        [UnityTest]
        public IEnumerator TheFirstPicture_HoldsNone()
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            while (insect.State != InsectState.Ready)
                yield return null;

            Assert.That(Longest(insect), Is.Zero);
            yield return Frames(2);
            Assert.That(Longest(insect), Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator WhileTheGameIsPaused_NothingMoves_AndThenItGoesOnFromThere()
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            yield return Frames(10);

            Time.timeScale = 0f;
            yield return Frames(2);
            for (int frame = 0; frame < 3; frame++)
            {
                yield return null;
                Assert.That(Longest(insect), Is.Zero);
            }

            Vector3[] before = Shown(insect, 0).vertices;
            Time.timeScale = 1f;
            yield return Frames(2);
            AssertWays(Shown(insect, 0), before);
            Assert.That(Longest(insect), Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator AfterAReset_NothingHasMoved([Values] bool teleport)
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            yield return Frames(10);

            Vector3[] before = Shown(insect, 0).vertices;
            if (teleport)
                insect.Teleport(keepMotion: false);
            else
                insect.ResetState();
            yield return null;
            Assert.That(Farthest(Shown(insect, 0).vertices, before), Is.GreaterThan(0.01f), "the reset was not seen");
            Assert.That(Longest(insect), Is.Zero);
            yield return Frames(2);
            Assert.That(Longest(insect), Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator WingsThatNobodySaw_HaveNotMoved_WhenTheyAreSeenAgain()
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            yield return Frames(10);

            insect.Quality.culling = WingCulling.CullSkinning;
            yield return Frames(10);
            Assert.That(Longest(insect), Is.Zero);
            Vector3[] before = Shown(insect, 0).vertices;
            insect.Quality.culling = WingCulling.AlwaysSimulate;
            yield return null;
            Assert.That(Farthest(Shown(insect, 0).vertices, before), Is.GreaterThan(0.01f), "the wings did not go on");
            Assert.That(Longest(insect), Is.Zero);
        }

        [UnityTest]
        public IEnumerator WithoutThem_MeshAndRenderer_AreAsEver()
        {
            InsectWings insect = Hatch(
                made => made.Wings[0].Renderer.motionVectorGenerationMode = MotionVectorGenerationMode.ForceNoMotion);
            yield return Frames(5);

            Assert.That(Shown(insect, 0).HasVertexAttribute(VertexAttribute.TexCoord5), Is.False);
            Assert.That(insect.Wings[0].Renderer.motionVectorGenerationMode, Is.EqualTo(MotionVectorGenerationMode.ForceNoMotion));
        }

        [UnityTest]
        public IEnumerator WhileTheyAreOn_TheRendererMoves_AndTheWingsBeatOn()
        {
            InsectWings insect = Hatch(made => made.Wings[0].Renderer.motionVectorGenerationMode = MotionVectorGenerationMode.Camera);
            InsectWings twin = Hatch();
            yield return Frames(10);

            insect.Quality.motionVectors = true;
            yield return Frames(10);
            MeshRenderer renderer = insect.Wings[0].Renderer;
            Assert.That(renderer.motionVectorGenerationMode, Is.EqualTo(MotionVectorGenerationMode.Object));
            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(1e-4f));
            Assert.That(Longest(insect), Is.GreaterThan(0f));

            insect.Quality.motionVectors = false;
            yield return Frames(2);
            Assert.That(renderer.motionVectorGenerationMode, Is.EqualTo(MotionVectorGenerationMode.Camera));
            Assert.That(Shown(insect, 0).HasVertexAttribute(VertexAttribute.TexCoord5), Is.False);
            insect.Quality.motionVectors = true;
            yield return Frames(2);
            insect.enabled = false;
            Assert.That(renderer.motionVectorGenerationMode, Is.EqualTo(MotionVectorGenerationMode.Camera));
        }

        // A renderer that a script destroyed has no mode to get back.
        [UnityTest]
        public IEnumerator AnInsectWhoseRendererIsGone_EndsWithoutAnError()
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            yield return Frames(3);

            Object.DestroyImmediate(insect.Wings[0].Renderer);
            insect.enabled = false;
            yield return Frames(2);
            Assert.That(insect.Live, Is.Null.Or.Property("meshes").Empty);
        }

        // Colours alone are one word a vertex beside positions and normals; the ways have a stream of their own.
        [UnityTest]
        public IEnumerator ColoursAlone_StayWhatTheyAre()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.uv = null;
            mesh.colors32 = System.Array.ConvertAll(mesh.vertices, place => new Color32((byte)(1 + 90f * Mathf.Abs(place.x)), 20, 3, 255));
            InsectWings insect = Hatch(made =>
            {
                made.Quality.motionVectors = true;
                Filter(made, 0).sharedMesh = mesh;
            });
            yield return Frames(5);

            Assert.That(Shown(insect, 0).colors32, Is.EquivalentTo(mesh.colors32));
            Assert.That(Longest(insect), Is.InRange(1e-3f, 1f));
        }

        [UnityTest]
        public IEnumerator CoordinatesOfTheMesh_InTheirPlace_GoAway_AndOthersStay()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            Vector2[] marks = System.Array.ConvertAll(mesh.vertices, place => new Vector2(place.x, 7f));
            foreach (int channel in new[] { 4, k_Channel, 6 })
                mesh.SetUVs(channel, marks);
            InsectWings insect = Hatch(made =>
            {
                made.Quality.motionVectors = true;
                Filter(made, 0).sharedMesh = mesh;
            });
            yield return Frames(10);

            var shown = new List<Vector4>();
            foreach (int channel in new[] { 4, 6 })
            {
                Shown(insect, 0).GetUVs(channel, shown);
                Assert.That(shown, Has.All.Matches<Vector4>(mark => mark.y == 7f));
            }

            Shown(insect, 0).GetUVs(k_Channel, shown);
            Assert.That(shown, Has.All.Matches<Vector4>(way => way.magnitude < 1f));
        }

        private static void AssertWays(Mesh mesh, Vector3[] before)
        {
            Vector3[] now = mesh.vertices;
            List<Vector4> ways = Ways(mesh);
            for (int v = 0; v < now.Length; v++)
            {
                Vector3 moved = now[v] - before[v];
                Assert.That(((Vector3)ways[v] - moved).magnitude, Is.LessThan(k_Least + k_Half * moved.magnitude), $"vertex {v}");
                Assert.That(ways[v].w, Is.Zero);
            }
        }

        private static float Longest(InsectWings insect)
        {
            float longest = 0f;
            foreach (Vector4 way in Ways(Shown(insect, 0)))
                longest = Mathf.Max(longest, ((Vector3)way).magnitude);
            return longest;
        }

        private static List<Vector4> Ways(Mesh mesh)
        {
            var ways = new List<Vector4>();
            mesh.GetUVs(k_Channel, ways);
            return ways;
        }

        private static float Farthest(Vector3[] a, Vector3[] b)
        {
            float farthest = 0f;
            for (int v = 0; v < a.Length; v++)
                farthest = Mathf.Max(farthest, (a[v] - b[v]).magnitude);
            return farthest;
        }
    }
}
