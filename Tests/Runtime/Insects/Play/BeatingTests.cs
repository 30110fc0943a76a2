using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    public sealed class BeatingTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator AnInsect_BeatsAtThePresetsFrequency()
        {
            InsectWings insect = Insect();
            yield return Frames(2);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);

            float start = Phase(insect);
            yield return Frames(120);
            float beats = Phase(insect) - start;

            // At rest a monarch keeps 0.8 of its 11 Hz.
            Assert.That(beats / 2f, Is.EqualTo(0.8f * 11f).Within(0.01f * 8.8f));
        }

        [UnityTest]
        public IEnumerator APrefabOfNothingButMeshes_LivesAndBeats()
        {
            GameObject bare = Bare();
            InsectWings insect = bare.AddComponent<InsectWings>();
            insect.FindWings();
            insect.Quality.culling = WingCulling.AlwaysSimulate;
            yield return Frames(2);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
            Assert.That(insect.Wings, Has.Count.EqualTo(2));

            float start = Phase(insect);
            yield return Frames(120);

            Assert.That((Phase(insect) - start) / 2f, Is.EqualTo(8.8f).Within(0.088f));
            AssertMirrored(insect);
        }

        [UnityTest]
        public IEnumerator LeftAndRightWings_AreMirrorImages()
        {
            InsectWings insect = Insect();
            yield return Frames(120);

            AssertMirrored(insect);
        }

        [UnityTest]
        public IEnumerator Disabling_GivesTheAuthoredMeshesBack()
        {
            InsectWings insect = Insect();
            Mesh authored = Shown(insect, 0);
            yield return Frames(3);
            Assert.That(Shown(insect, 0), Is.Not.SameAs(authored));

            insect.enabled = false;

            Assert.That(Shown(insect, 0), Is.SameAs(authored));
            Assert.That(insect.State, Is.EqualTo(InsectState.Inactive));
        }

        private static void AssertMirrored(InsectWings insect)
        {
            Vector3[] right = Shown(insect, 0).vertices, left = Shown(insect, 1).vertices;
            Vector3[] rest = insect.Wings[0].Authored.vertices;
            float span = 0.61f, worst = 0f, moved = 0f;
            for (int v = 0; v < right.Length; v++)
            {
                worst = Mathf.Max(worst, (Vector3.Scale(left[v], new Vector3(-1f, 1f, 1f)) - right[v]).magnitude);
                moved = Mathf.Max(moved, (right[v] - rest[v]).magnitude);
            }

            Assert.That(worst, Is.LessThan(1e-4f * span));
            Assert.That(moved, Is.GreaterThan(0.1f * span), "the wing did not move");
        }

        private static float Phase(InsectWings insect)
        {
            WingReading reading = insect.Read(0);
            return reading.Beats + reading.Phase / (2f * Mathf.PI);
        }
    }
}
