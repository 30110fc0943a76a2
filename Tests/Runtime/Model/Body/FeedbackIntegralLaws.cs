using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Integral of the velocity's error: what it sums, when it waits, and how far it goes.</summary>
    public sealed unsafe class FeedbackIntegralLaws
    {
        [Test]
        public void TheIntegral_GrowsByErrorAndTime_WhileNothingIsClippedOrLost()
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            body.velocity = new float3(0.1f, -0.2f, 0.3f);
            float3 sum = default;
            foreach (float time in new[] { 0.05f, 0.1f, 0.02f })
            {
                body.sinceSample = time;
                BodyFeedback.Sample(ref body, 0f, point);
                sum += time * body.velocity;
                Assert.That(math.distance(body.integral, sum), Is.LessThan(1e-6f));
                Assert.That(body.sinceSample, Is.Zero, "each time counts once");
            }
        }

        // Anti-windup: an error that the wings cannot fly off, or are already flying off as hard as they can, must not be stored.
        [Test]
        public void TheIntegral_Waits_WhileCommandsAreClipped()
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            point[TrimPoint.LongGains + 1] = 100f;
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            body.velocity = new float3(0f, 0f, 0.2f);
            body.sinceSample = 0.1f;
            BodyFeedback.Sample(ref body, 0f, point);
            float3 first = body.integral;
            Assert.That(body.clipped, Is.EqualTo(1));
            Assert.That(first.z, Is.EqualTo(0.02f).Within(1e-6f), "what was clipped counts from the next sample on");
            body.sinceSample = 0.1f;
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(body.integral, Is.EqualTo(first));
            Clear(point);
            for (int k = 0; k < 2; k++)
            {
                body.sinceSample = 0.1f;
                BodyFeedback.Sample(ref body, 0f, point);
            }

            Assert.That(body.clipped, Is.Zero);
            Assert.That(body.integral.z, Is.EqualTo(first.z + 0.02f).Within(1e-6f), "and goes on when nothing is");
        }

        // From 70° off on attitude alone is commanded, with all the power that there is, until the body is within 30° and turns by less
        // than 15 rad/s.
        [TestCase(69f, 0f, false)]
        [TestCase(71f, 0f, true)]
        [TestCase(31f, 0f, true)]
        [TestCase(29f, 16f, true)]
        [TestCase(29f, 14f, false)]
        public void ABodyThatTumbled_HeedsNoVelocity_UntilItHasRightedItself(float tilt, float rate, bool rights)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            point[TrimPoint.LongGains + 1] = 5f;
            FlyingBody body = default;
            body.recovers = 1;
            body.rights = tilt < 69f ? 1 : 0;
            body.rotation = quaternion.RotateZ(math.radians(tilt));
            body.spin = new float3(0f, 0f, rate);
            body.velocity = new float3(0f, 0f, 0.2f);
            body.integral = 0.1f;
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(body.rights, Is.EqualTo(rights ? 1 : 0));
            Assert.That(body.Last(0), Is.EqualTo(rights ? FlightCommands.Limit(0) : -1f).Within(1e-6f), "frequency");
            Assert.That(body.Last(1), Is.EqualTo(rights ? FlightCommands.Limit(1) : 0f).Within(1e-6f), "stroke");
            Assert.That(math.all(body.integral == (rights ? 0f : 0.1f)));

            body.recovers = 0;
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(body.rights, Is.Zero, "unguarded it tumbles on");
            Assert.That(body.Last(0), Is.EqualTo(-1f).Within(1e-6f));
        }

        [Test]
        public void TheIntegral_Waits_WhileTheInsectIsThrownAbout([Values(0.49f, 0.51f)] float speed)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            body.velocity = new float3(0f, speed, 0f);
            body.sinceSample = 0.1f;
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(body.integral.y, Is.EqualTo(speed < 0.5f ? 0.1f * speed : 0f).Within(1e-6f));
        }

        [Test]
        public void TheIntegral_IsBoundedByAMetre_OnEverySide([Values(0, 1, 2)] int axis, [Values(-1f, 1f)] float sign)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            body.velocity[axis] = sign * 0.4f;
            for (int beat = 0; beat < 40; beat++)
            {
                body.sinceSample = 0.1f;
                BodyFeedback.Sample(ref body, 0f, point);
            }

            Assert.That(body.integral[axis], Is.EqualTo(sign).Within(1e-6f));
            body.velocity = -body.velocity;
            body.sinceSample = 0.1f;
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(body.integral[axis], Is.EqualTo(0.96f * sign).Within(1e-5f), "and comes back at once");
        }

        private static void Clear(float* point)
        {
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = 0f;
        }
    }
}
