using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Smooth motion of the drawn pose between fixed steps.</summary>
    public sealed class SmoothnessTests : PlayFixture
    {
        private const float k_FrameRate = 144f;

        [UnityTest]
        public IEnumerator FixedSteps_AreDrawnSmoothlyAtHighFrameRates()
        {
            Time.captureDeltaTime = 1f / k_FrameRate;
            InsectWings insect = Insect();
            yield return Frames(144);
            var tips = new List<Vector3>();
            for (int frame = 0; frame < 288; frame++)
            {
                tips.Add(Tip(insect));
                yield return null;
            }

            float largest = 0f;
            for (int k = 1; k + 1 < tips.Count; k++)
            {
                Assert.That((tips[k] - tips[k - 1]).magnitude, Is.GreaterThan(1e-6f), $"frame {k} repeats the pose before it");
                largest = Mathf.Max(largest, (tips[k + 1] - 2f * tips[k] + tips[k - 1]).magnitude);
            }

            // A point that swings by half the flapping range at this rate is accelerated by no more than ω²A; flexing adds to it, a jump
            // would multiply it.
            float rate = 2f * Mathf.PI * insect.Frequency, amplitude = 0.61f * Mathf.Deg2Rad * 0.5f * insect.FlapRange;
            float swing = rate * rate * amplitude / (k_FrameRate * k_FrameRate);
            Assert.That(largest, Is.LessThan(2f * swing), $"{largest / swing} of a swing's");
        }

        private static Vector3 Tip(InsectWings insect)
        {
            Vector3 farthest = default;
            foreach (Vector3 vertex in Shown(insect, 0).vertices)
            {
                if (vertex.sqrMagnitude > farthest.sqrMagnitude)
                    farthest = vertex;
            }

            return farthest;
        }
    }
}
