using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Help from outside: none for small errors, against large ones, bounded by the weight.</summary>
    public sealed class BodyAidLaws
    {
        private const float k_Mass = 4e-4f, k_Frequency = 11f, k_Length = 0.06f, k_Gravity = 9.81f, k_Weight = k_Gravity * k_Mass;

        private TrimTableMemory m_Table;

        [SetUp]
        public void SetUp()
        {
            m_Table = new TrimTableMemory(new float[1], new float[1]);
            float[] point = new float[TrimPoint.Floats];
            point[TrimPoint.Pitch] = 0.5f;
            m_Table.Write(0, 0, point);
        }

        [TearDown]
        public void TearDown() => m_Table.Dispose();

        // Nothing up to 0.4 m/s, all of m · 4/s · error from 0.6 m/s on, half a weight at the most.
        [Test]
        public void TheForce_IsAgainstTheErrorOfTheVelocity([Values(0.1f, 0.39f, 0.45f, 0.5f, 0.6f, 0.8f, 4f)] float speed,
            [Values(0.3f, 1f)] float strength)
        {
            FlyingBody body = Body(strength);
            float3 direction = math.normalize(new float3(1f, -2f, 3f));
            body.velocity = body.reference.velocity + speed * direction;
            BodyAid.Evaluate(ref body, 0f);
            float share = math.saturate(2f * (speed / 0.4f - 1f)),
                expected = strength * math.min(4f * k_Mass * share * speed, 0.5f * k_Weight);
            Assert.That(math.distance(body.aidForce, -expected * direction), Is.LessThan(1e-5f * k_Weight));
            Assert.That(math.length(body.aidMoment), Is.Zero);
            Assert.That(body.aidPower, Is.EqualTo(math.dot(body.aidForce, body.velocity)).Within(1e-8f));
        }

        // A turn of the body, critically damped at four times its beat: J (ω² e + 2 ω w).
        [Test]
        public void TheMoment_TurnsTheBodyBack([Values(0, 2)] int axis, [Values(-1f, 1f)] float sign,
            [Values(0.5f, 0.53f, 0.6f, 0.8f)] float angle, [Values(0.2f, 1f)] float strength)
        {
            FlyingBody body = Body(strength);
            body.inertia = 1e-11f * new float3x3(2f, 0.3f, -0.2f, 0.3f, 3f, 0.4f, -0.2f, 0.4f, 4f);
            float3 error = default, rate = new float3(3f, -2f, 1f);
            error[axis] = sign * angle;
            body.velocity = body.reference.velocity;
            var heading = quaternion.AxisAngle(new float3(0f, 1f, 0f), body.reference.heading);
            body.rotation = math.mul(BodyMotion.Turn(math.rotate(heading, error)), body.rotation);
            body.spin = math.rotate(math.conjugate(body.rotation), math.rotate(heading, rate));
            BodyAid.Evaluate(ref body, 0f);
            float omega = 4f * k_Frequency;
            float share = math.saturate(2f * (angle / (math.PI / 6f) - 1f));
            float3 turn = math.rotate(math.conjugate(body.rotation),
                math.rotate(heading, omega * omega * share * error + 2f * omega * rate));
            float3 expected = angle > math.PI / 6f ? -strength * math.mul(body.inertia, turn) : default;
            Assert.That(math.length(expected), Is.LessThan(strength * k_Weight * k_Length), "not bounded here");
            Assert.That(math.distance(body.aidMoment, expected), Is.LessThan(1e-3f * math.length(expected) + 1e-15f));
            Assert.That(body.aidPower, Is.EqualTo(math.dot(body.aidMoment, body.spin)).Within(1e-9f));
        }

        [Test]
        public void TheMoment_IsAtMostTheWeightOnAWingsLength([Values(0.5f, 1f)] float strength)
        {
            FlyingBody body = Body(strength);
            body.inertia = 1e-3f * float3x3.identity;
            body.rotation = math.mul(quaternion.AxisAngle(new float3(1f, 0f, 0f), 1.5f), body.rotation);
            body.velocity = body.reference.velocity;
            BodyAid.Evaluate(ref body, 0f);
            Assert.That(math.length(body.aidMoment), Is.EqualTo(strength * k_Weight * k_Length).Within(1e-4f * k_Weight * k_Length));
        }

        // Half a weight, and a weight on a wing's length, in the gravity of the scene, wherever it pulls to.
        [Test]
        public void Bounds_AreThoseOfTheScenesGravity([Values(0f, 1.62f, 9.81f, 25f)] float gravity)
        {
            FlyingBody body = Body(1f);
            body.gravity = gravity * math.normalize(new float3(1f, -2f, 0.5f));
            body.inertia = 1e-3f * float3x3.identity;
            body.rotation = math.mul(quaternion.AxisAngle(new float3(1f, 0f, 0f), 1.5f), body.rotation);
            body.velocity = body.reference.velocity + new float3(0f, -50f, 0f);
            BodyAid.Evaluate(ref body, 0f);
            float weight = gravity * k_Mass;
            Assert.That(math.length(body.aidForce), Is.EqualTo(0.5f * weight).Within(1e-5f * k_Weight));
            Assert.That(math.length(body.aidMoment), Is.EqualTo(weight * k_Length).Within(1e-4f * k_Weight * k_Length));
        }

        // An insect that looks back is upright: it is turned about the vertical, and no more than by 0.8 rad.
        [Test]
        public void AnInsectThatLooksTheWrongWay_IsTurnedAboutTheVertical([Values(0.9f, 2f, -2f)] float off)
        {
            FlyingBody body = Body(1f);
            body.inertia = 1e-11f * float3x3.identity;
            body.rotation = math.mul(quaternion.AxisAngle(new float3(0f, 1f, 0f), off), body.rotation);
            body.velocity = body.reference.velocity;
            BodyAid.Evaluate(ref body, 0f);
            float omega = 4f * k_Frequency, expected = -1e-11f * omega * omega * math.clamp(off, -0.8f, 0.8f);
            Assert.That(math.distance(math.rotate(body.rotation, body.aidMoment), new float3(0f, expected, 0f)),
                Is.LessThan(1e-4f * math.abs(expected)));
        }

        [Test]
        public void WithoutAid_NothingIsLeftOfTheLastOne()
        {
            FlyingBody body = Body(0f);
            body.velocity = 5f;
            body.aidForce = body.aidMoment = 1f;
            BodyAid.Evaluate(ref body, 0f);
            Assert.That(math.length(body.aidForce) + math.length(body.aidMoment) + body.aidPower, Is.Zero);
        }

        [Test]
        public void ThePowerOfSubsteps_AddsUp()
        {
            FlyingBody body = Body(1f);
            body.velocity = body.reference.velocity + new float3(0f, -1f, 0f);
            BodyAid.Evaluate(ref body, 0f);
            float once = body.aidPower;
            BodyAid.Evaluate(ref body, 0f);
            Assert.That(once, Is.Not.Zero);
            Assert.That(body.aidPower, Is.EqualTo(2f * once).Within(1e-6f * math.abs(once)));
        }

        private FlyingBody Body(float strength)
        {
            FlyingBody body = default;
            body.mass = k_Mass;
            body.inertia = 2e-8f * float3x3.identity;
            body.frequency = k_Frequency;
            body.length = k_Length;
            body.gravity = new float3(0f, -k_Gravity, 0f);
            body.aid = strength;
            body.table = m_Table.View;
            body.reference.heading = 0.8f;
            body.reference.velocity = new float3(0.3f, 0.1f, -0.2f);
            body.rotation = math.mul(quaternion.AxisAngle(new float3(0f, 1f, 0f), 0.8f),
                quaternion.AxisAngle(new float3(1f, 0f, 0f), -0.5f));
            return body;
        }
    }
}
