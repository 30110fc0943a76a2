using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Errors that the feedback measures, and commands that it makes of them.</summary>
    public sealed unsafe class BodyFeedbackLaws
    {
        [Test]
        public void Errors_AreTheDeparturesFromReferenceTrimAndBob([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            float* point = stackalloc float[TrimPoint.Floats];
            Fill(point, ref random);
            point[TrimPoint.Pitch] = random.NextFloat(-0.3f, 1.2f);
            FlyingBody body = default;
            body.reference = new BodyReference
            {
                heading = random.NextFloat(-3f, 3f),
                velocity = random.NextFloat3(-1f, 1f),
                turning = random.NextFloat(-2f, 2f)
            };
            var bob = new BodyBob
            {
                velocity = random.NextFloat3(-0.2f, 0.2f),
                turn = random.NextFloat(-0.2f, 0.2f),
                rate = random.NextFloat(-5f, 5f)
            };
            float3 velocity = random.NextFloat3(-1f, 1f), turn = random.NextFloat3(-0.8f, 0.8f), rate = random.NextFloat3(-9f, 9f);

            // Out of the trimmed attitude, nose up by the pitch along the heading, turned by the error along the heading's axes.
            quaternion heading = About(1, body.reference.heading);
            body.rotation = math.mul(BodyMotion.Turn(math.rotate(heading, turn + new float3(bob.turn, 0f, 0f))),
                math.mul(heading, About(0, -point[TrimPoint.Pitch])));
            body.velocity = body.reference.velocity + math.rotate(heading, velocity + bob.velocity);
            body.spin = math.rotate(math.conjugate(body.rotation),
                math.rotate(heading, rate + new float3(bob.rate, body.reference.turning, 0f)));
            quaternion wanted = BodyFeedback.Errors(ref body, point, bob);
            Assert.That(math.distance(body.velocityError, velocity), Is.LessThan(1e-5f));
            Assert.That(math.distance(body.turnError, turn), Is.LessThan(1e-5f));
            Assert.That(math.distance(body.rateError, rate), Is.LessThan(3e-5f));
            Assert.That(math.distance(wanted.value, heading.value), Is.LessThan(1e-6f));
        }

        [Test]
        public void ABodyThatLooksTheWrongWay_IsUpright([Values(-2.5f, -0.5f, 0.3f, 2f, 3f)] float off, [Values(-0.4f, 0.3f)] float tilt)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            point[TrimPoint.Pitch] = 0.6f;
            FlyingBody body = default;
            body.reference.heading = 0.7f;
            quaternion own = About(1, 0.7f + off);
            body.rotation = math.mul(math.mul(own, About(2, tilt)), About(0, -0.6f));
            float3 apart = BodyFeedback.TurnApart(body, point, default, out quaternion heading);
            Assert.That(math.distance(apart, new float3(0f, math.clamp(off, -0.8f, 0.8f), tilt)), Is.LessThan(1e-5f));
            Assert.That(math.abs(math.dot(heading.value, own.value)), Is.EqualTo(1f).Within(1e-6f));
            BodyFeedback.Errors(ref body, point, default);
            Assert.That(body.tilt, Is.EqualTo(math.abs(tilt)).Within(1e-5f));
        }

        [Test]
        public void TheBobOfTheTurn_IsNoTilt()
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            FlyingBody body = default;
            body.rotation = About(0, 0.25f);
            Assert.That(math.length(BodyFeedback.TurnApart(body, point, new BodyBob { turn = 0.25f }, out _)), Is.LessThan(1e-6f));
            BodyFeedback.Errors(ref body, point, new BodyBob { turn = 0.25f });
            Assert.That(body.tilt, Is.LessThan(1e-6f));
        }

        [Test]
        public void ABodyTumbles_FromSeventyDegreesOn([Values(69.5f, 70.5f, -69.5f, -70.5f)] float degrees)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            FlyingBody body = default;
            body.rotation = About(2, math.radians(degrees));
            BodyFeedback.Errors(ref body, point, default);
            Assert.That(body.Tumbles, Is.EqualTo(math.abs(degrees) > 70f));
        }

        // u = −K x, x the errors, the lean that a turn needs, the integral of before, and the last commands.
        [Test]
        public void Commands_AreTheGainsTimesTheErrors([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            float* point = stackalloc float[TrimPoint.Floats];
            Fill(point, ref random);
            FlyingBody body = Flown(ref random, point);
            float gravity = random.NextFloat(4f, 15f);
            body.gravity = gravity * random.NextFloat3Direction();
            body.integral = random.NextFloat3(-0.3f, 0.3f);
            for (int k = 0; k < FlightCommands.Count; k++)
                body.last[k] = random.NextFloat(-0.2f, 0.2f);
            FlyingBody before = body;
            BodyFeedback.Sample(ref body, 1f, point);
            float3 v = body.velocityError, e = body.turnError, w = body.rateError, i = before.integral;
            float3 right = math.rotate(About(1, body.reference.heading), new float3(1f, 0f, 0f));
            e.z += math.dot(right, body.reference.acceleration) / gravity;
            float[] along = { v.y, v.z, e.x, w.x, i.y, i.z, before.Last(0), before.Last(1), before.Last(2), before.Last(3) };
            float[] aside = { v.x, e.y, e.z, w.y, w.z, i.x, before.Last(4), before.Last(5) };
            for (int command = 0; command < 6; command++)
            {
                float[] states = command < 4 ? along : aside;
                float* gains = point + (command < 4 ? TrimPoint.LongGains + command * 10 : TrimPoint.SideGains + (command - 4) * 8);
                float expected = 0f;
                for (int k = 0; k < states.Length; k++)
                    expected -= gains[k] * states[k];
                Assert.That(body.Last(command), Is.EqualTo(expected).Within(1e-5f), $"command {command}");
            }

            Assert.That(body.clipped, Is.Zero);
        }

        // The lean that a turn needs goes by the scene's gravity: more on the moon, at most one radian, none where nothing is to be held
        // up.
        [TestCase(9.81f, 2f / 9.81f)]
        [TestCase(4f, 0.5f)]
        [TestCase(0.5f, 1f)]
        [TestCase(0f, 0f)]
        public void TheLean_GoesByTheScenesGravity(float gravity, float lean)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            point[TrimPoint.SideGains + 2] = 0.1f;
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            body.gravity = new float3(0f, -gravity, 0f);
            body.reference.acceleration = new float3(2f, 0f, 0f);
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(-body.Last(4), Is.EqualTo(0.1f * lean).Within(1e-6f),
                "the error of the roll is that of an upright body less its lean");
        }

        [Test]
        public void LargeErrorsOfTheVelocity_CountAsHalfAMetreASecond_InTheirDirection([Values(0.4f, 0.6f, 3f)] float size)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            point[TrimPoint.LongGains] = point[TrimPoint.LongGains + 10 + 1] = point[TrimPoint.SideGains] = 1f;
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            body.velocity = size * new float3(2f, 1f, -2f) / 3f;
            BodyFeedback.Sample(ref body, 0f, point);
            float3 counted = math.min(size, 0.5f) * new float3(2f, 1f, -2f) / 3f;
            Assert.That(math.distance(-new float3(body.Last(4), body.Last(0), body.Last(1)), counted), Is.LessThan(1e-6f));
        }

        // Limits of the manual in their own units: 15 % of the frequency, 0.2 of the amplitude, 20° of tilt and mean sweep, 0.2 and 15°
        // between the sides.
        [Test]
        public void EveryCommand_IsHeldAtItsLimit_UpAndDown([Values(0, 1, 2, 3, 4, 5)] int command, [Values(-1f, 1f)] float sign)
        {
            float[] limits = { 0.15f * 12f, 0.2f, math.radians(20f), math.radians(20f), 0.2f, math.radians(15f) };
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            point[(command < 4 ? TrimPoint.LongGains + command * 10 : TrimPoint.SideGains + (command - 4) * 8) + (command < 4 ? 1 : 0)] =
                -100f;
            FlyingBody body = default;
            body.frequency = 12f;
            body.rotation = quaternion.identity;
            body.velocity = sign * new float3(0.1f, 0f, 0.1f);
            BodyFeedback.Sample(ref body, 0f, point);
            Assert.That(body.Last(command) * FlightCommands.Unit(command, 12f), Is.EqualTo(sign * limits[command]).Within(1e-5f));
            Assert.That(body.clipped, Is.EqualTo(1));
            point[TrimPoint.Drive] = 11f;
            point[TrimPoint.Drive + 1] = 1f;
            WingDrive right = BodyFeedback.Drive(body, point, 1f), left = BodyFeedback.Drive(body, point, -1f);
            float change = sign * limits[command];
            Assert.That(right.frequency - 11f, Is.EqualTo(command == 0 ? change : 0f).Within(1e-5f));
            Assert.That(right.amplitude - 1f, Is.EqualTo(command == 1 || command == 4 ? change : 0f).Within(1e-6f));
            Assert.That(left.amplitude - 1f, Is.EqualTo(command == 1 ? change : command == 4 ? -change : 0f).Within(1e-6f));
            Assert.That(right.tilt, Is.EqualTo(command == 2 ? change : 0f).Within(1e-6f));
            Assert.That(right.meanSweep, Is.EqualTo(command == 3 ? change : 0f).Within(1e-6f));
            Assert.That(right.meanFeather, Is.EqualTo(command == 5 ? change : 0f).Within(1e-6f));
            Assert.That(left.meanFeather, Is.EqualTo(-right.meanFeather));
            Assert.That(new float3(left.frequency, left.tilt, left.meanSweep),
                Is.EqualTo(new float3(right.frequency, right.tilt, right.meanSweep)));
            Assert.That(right.meanFlap, Is.Zero);
        }

        [Test]
        public void Drives_StayWithinWhatAWingTakes()
        {
            float* point = stackalloc float[TrimPoint.Floats];
            Clear(point);
            FlyingBody body = default;
            point[TrimPoint.Drive] = -5f;
            point[TrimPoint.Drive + 1] = -1f;
            Assert.That(BodyFeedback.Drive(body, point, 1f).IsValid);
            point[TrimPoint.Drive] = 5000f;
            point[TrimPoint.Drive + 1] = 9f;
            Assert.That(BodyFeedback.Drive(body, point, 1f).IsValid);
        }

        // An insect that is mirrored left to right is commanded the same, with the sides exchanged.
        [Test]
        public void AMirroredBody_IsCommandedItsMirrorImage([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            float* point = stackalloc float[TrimPoint.Floats];
            Fill(point, ref random);
            FlyingBody body = Flown(ref random, point), mirrored = body;
            float3 mirror = new float3(-1f, 1f, 1f), axial = new float3(1f, -1f, -1f);
            mirrored.velocity *= mirror;
            mirrored.spin *= axial;
            mirrored.rotation.value *= new float4(axial, 1f);
            mirrored.reference.velocity *= mirror;
            mirrored.reference.acceleration *= mirror;
            mirrored.reference.heading = -body.reference.heading;
            mirrored.reference.turning = -body.reference.turning;
            for (int beat = 0; beat < 3; beat++)
            {
                body.sinceSample = mirrored.sinceSample = 0.1f;
                BodyFeedback.Sample(ref body, 1f, point);
                BodyFeedback.Sample(ref mirrored, 1f, point);
                for (int command = 0; command < 6; command++)
                {
                    Assert.That(mirrored.Last(command), Is.EqualTo(command < 4 ? body.Last(command) : -body.Last(command)).Within(1e-4f),
                        $"command {command}");
                }
            }
        }

        // Along whatever heading it flies, an insect is commanded the same.
        [Test]
        public void ATurnedScene_IsFlownTheSame([Values(1u, 2u, 3u)] uint seed, [Values(-2f, 0.7f)] float by)
        {
            var random = Random.CreateFromIndex(seed);
            float* point = stackalloc float[TrimPoint.Floats];
            Fill(point, ref random);
            FlyingBody body = Flown(ref random, point), turned = body;
            quaternion turn = About(1, by);
            turned.velocity = math.rotate(turn, body.velocity);
            turned.rotation = math.mul(turn, body.rotation);
            turned.reference.velocity = math.rotate(turn, body.reference.velocity);
            turned.reference.acceleration = math.rotate(turn, body.reference.acceleration);
            turned.reference.heading += by;
            BodyFeedback.Sample(ref body, 2f, point);
            BodyFeedback.Sample(ref turned, 2f, point);
            for (int command = 0; command < 6; command++)
                Assert.That(turned.Last(command), Is.EqualTo(body.Last(command)).Within(1e-5f), $"command {command}");
        }

        private static FlyingBody Flown(ref Random random, float* point)
        {
            FlyingBody body = default;
            body.frequency = 11f;
            body.reference = new BodyReference
            {
                heading = random.NextFloat(-3f, 3f),
                velocity = random.NextFloat3(-1f, 1f),
                acceleration = random.NextFloat3(-2f, 2f),
                turning = random.NextFloat(-1f, 1f),
            };
            body.velocity = body.reference.velocity + random.NextFloat3(-0.1f, 0.1f);
            quaternion trimmed = math.mul(About(1, body.reference.heading), About(0, -point[TrimPoint.Pitch]));
            body.rotation = math.mul(BodyMotion.Turn(random.NextFloat3(-0.3f, 0.3f)), trimmed);
            body.spin = random.NextFloat3(-1f, 1f);
            return body;
        }

        private static void Fill(float* point, ref Random random)
        {
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = random.NextFloat(-0.3f, 0.3f);
            for (int k = TrimPoint.Bob; k < TrimPoint.LongGains; k++)
                point[k] *= 0.02f;
        }

        private static void Clear(float* point)
        {
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = 0f;
        }

        private static quaternion About(int axis, float angle)
        {
            float3 along = default;
            along[axis] = 1f;
            return quaternion.AxisAngle(along, angle);
        }
    }
}
