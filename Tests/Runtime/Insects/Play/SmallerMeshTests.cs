using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects that look small are drawn with fewer triangles, and with all of them again from near.</summary>
    public sealed class SmallerMeshTests : DetailFixture
    {
        private const float k_Near = 0.5f, k_Far = 0.05f;

        /// <summary>Corners of the triangles that remain of the wing's 144.</summary>
        private const int k_Few = 3 * 64;

        [UnityTest]
        public IEnumerator BelowCoarsePatches_FewerTrianglesAreDrawn()
        {
            InsectWings insect = Hatch();
            int[] whole = WingMesh.triangles;
            foreach ((float height, bool smaller) in new[]
                { (k_Near, false), (0.15f, false), (k_Far, true), (0.02f, true), (0.15f, false), (k_Far, true), (k_Near, false) })
            {
                Look(insect, height);
                yield return Frames(3);
                Assert.That(Shown(insect, 0).triangles, Has.Length.EqualTo(smaller ? k_Few : whole.Length), $"{height}");
                Assert.That(Shown(insect, 1).triangles, Has.Length.EqualTo(smaller ? k_Few : whole.Length), $"{height}");
            }

            int[] order = Order(insect, 0);
            Assert.That(Shown(insect, 0).triangles.Select(v => order[v]), Is.EqualTo(whole), "as they were");
        }

        // Vertices that were left alone would tear the wing.
        [UnityTest]
        public IEnumerator WhatIsDrawn_IsThePresentPose([Values] bool paused)
        {
            InsectWings insect = Hatch();
            for (int round = 0; round < 8; round++)
            {
                Look(insect, round % 2 == 0 ? k_Near : k_Far);
                yield return Frames(2);
                AssertWhole(insect, $"round {round}");
                yield return Frames(5 + 2 * round);
                AssertWhole(insect, $"round {round}, later");
                Time.timeScale = paused && round % 2 == 1 ? 0f : 1f;
                yield return Frames(3);
            }
        }

        [UnityTest]
        public IEnumerator WhoComesBackIntoSight_IsWhole([Values] WingCulling culling)
        {
            InsectWings insect = Hatch(made => made.Quality.culling = culling);
            Look(insect, k_Near);
            yield return Frames(20);
            Show(insect, false);
            yield return Frames(20);
            Assert.That(Shown(insect, 0).triangles, Has.Length.EqualTo(WingMesh.triangles.Length), "who is out of sight keeps its mesh");
            Show(insect, true);
            Look(insect, k_Far);
            yield return Frames(20);
            Show(insect, false);
            yield return Frames(20);
            Look(insect, k_Near);
            yield return Frames(10);
            Show(insect, true);
            yield return Frames(2);
            AssertWhole(insect, "in sight again");
            Assert.That(Shown(insect, 0).triangles, Has.Length.EqualTo(WingMesh.triangles.Length));
        }

        [UnityTest]
        public IEnumerator WhenItGetsAllTrianglesAgain_NothingHasMoved()
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            Look(insect, k_Far);
            yield return Frames(20);
            int drawn = Shown(insect, 0).triangles.Max();
            Assert.That(Ways(insect).Take(drawn + 1).Max(), Is.GreaterThan(1e-3f));
            Look(insect, k_Near);
            yield return null;
            Assert.That(Ways(insect).Max(), Is.Zero, "those that were not deformed have no last place");
            yield return null;
            Assert.That(Ways(insect).Skip(drawn + 1).Max(), Is.GreaterThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator OneThatIsBuiltAgain_KeepsItsSize()
        {
            InsectWings insect = Hatch();
            Look(insect, k_Far);
            yield return Frames(20);
            insect.Quality.patches = 32;
            yield return Frames(3);
            Assert.That(Shown(insect, 0).triangles, Has.Length.EqualTo(k_Few));
            AssertWhole(insect, "built again");
        }

        // Making smaller parts takes time: only for insects that may need them.
        [UnityTest]
        public IEnumerator WithoutLevelsOfDetail_ThereAreNone_UntilTheyAreWanted()
        {
            InsectWings insect = Hatch(made => made.Quality.levelOfDetail = false), other = Hatch();
            Look(insect, k_Far);
            yield return Frames(5);
            Assert.That(insect.Live.meshes[0].template.Sizes, Is.Null);
            Assert.That(other.Live.meshes[0].template.Sizes, Is.Not.Null);
            Assert.That(Order(insect, 0), Is.Ordered, "its vertices are in the authored order");
            insect.Quality.levelOfDetail = true;
            yield return Frames(5);
            Assert.That(insect.Live.meshes[0].template, Is.SameAs(other.Live.meshes[0].template));
            Assert.That(Shown(insect, 0).triangles, Has.Length.EqualTo(k_Few));
        }

        private static void Show(InsectWings insect, bool seen)
        {
            foreach (Wing wing in insect.Wings)
                wing.Renderer.enabled = seen;
        }

        // Edges between drawn vertices keep their lengths at rest within the stretch of a wing.
        private static void AssertWhole(InsectWings insect, string when)
        {
            for (int wing = 0; wing < 2; wing++)
            {
                Mesh shown = Shown(insect, wing);
                Vector3[] now = shown.vertices;
                int[] corners = shown.triangles, order = Order(insect, wing);
                Vector3[] authored = insect.Live.meshes[wing].template.Source.vertices;
                for (int k = 0; k < corners.Length; k++)
                {
                    int a = corners[k], b = corners[k % 3 == 2 ? k - 2 : k + 1];
                    float rest = (authored[order[a]] - authored[order[b]]).magnitude, length = (now[a] - now[b]).magnitude;
                    Assert.That(length, Is.EqualTo(rest).Within(0.2f * rest + 0.002f), when);
                }
            }
        }

        private static IEnumerable<float> Ways(InsectWings insect)
        {
            var ways = new List<Vector3>();
            Shown(insect, 0).GetUVs(5, ways);
            return ways.Select(way => way.magnitude);
        }
    }
}
