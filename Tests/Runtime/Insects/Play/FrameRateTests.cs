using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Independence of the drawn pose from the number of frames before it.</summary>
    public sealed class FrameRateTests : PlayFixture
    {
        private const float k_Seconds = 2f, k_Span = 0.61f;

        private static readonly WingUpdateMode[] s_Modes = { WingUpdateMode.FixedUpdate, WingUpdateMode.Update,
            WingUpdateMode.UnscaledTime };

        private Vector3[] m_Drawn;

        [UnityTest]
        public IEnumerator AnyFrameRate_DrawsTheSameWingAfterTwoSeconds([ValueSource(nameof(s_Modes))] WingUpdateMode mode)
        {
            yield return Fly(mode, frame => 1f / 60f);
            Vector3[] expected = m_Drawn;
            Assert.That(expected, Is.Not.Empty);
            foreach (float rate in new[] { 24f, 30f, 144f, 1000f })
            {
                yield return Fly(mode, frame => 1f / rate);
                Assert.That(Farthest(expected, m_Drawn), Is.LessThan(0.01f * k_Span), $"{rate} frames a second");
            }
        }

        [UnityTest]
        public IEnumerator RandomFrameTimes_DrawTheSameWingAfterTwoSeconds([ValueSource(nameof(s_Modes))] WingUpdateMode mode)
        {
            yield return Fly(mode, frame => 1f / 60f);
            Vector3[] expected = m_Drawn;
            var random = new System.Random(20240818);
            yield return Fly(mode, frame => 0.002f + 0.05f * (float)random.NextDouble());
            Assert.That(Farthest(expected, m_Drawn), Is.LessThan(0.01f * k_Span));
        }

        // Two seconds in frames of these lengths, from the same point of both clocks; the last frame ends on time.
        private IEnumerator Fly(WingUpdateMode mode, System.Func<int, float> frameTime)
        {
            yield return Align();
            InsectWings insect = Insect();
            insect.UpdateMode = mode;
            insect.Motion.onTeleport = TeleportResponse.Ignore;
            float elapsed = 0f;
            for (int frame = 0; elapsed < k_Seconds - 1e-5f; frame++)
            {
                float next = Mathf.Min(frameTime(frame), k_Seconds - elapsed);
                Time.captureDeltaTime = next;
                elapsed += next;
                yield return null;
            }

            // The last frame is drawn after its Update.
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            m_Drawn = Shown(insect, 0).vertices;
            Object.Destroy(insect.gameObject);
            yield return Frames(2);
        }

        // Into a frame of a sixtieth of a second that ends half-way between two fixed steps.
        private static IEnumerator Align()
        {
            double grid = Time.fixedDeltaTime, frame = 1.0 / 60.0;
            double wanted = Time.fixedTimeAsDouble + 0.5 * grid - frame - Time.timeAsDouble;
            Time.captureDeltaTime = (float)(wanted - grid * System.Math.Floor(wanted / grid) + grid);
            yield return null;
            Time.captureDeltaTime = (float)frame;
            yield return null;
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
