using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>A step of a body with its wings: what it reads over its substeps, how it follows, what it forgets.</summary>
    public sealed class BodyStepLaws
    {
        // A step of n substeps reads the mean of n steps of one.
        [Test]
        public void ReadingsOfAStep_AreTheMeansOverItsSubsteps([Values(false, true)] bool held)
        {
            BodyMode mode = held ? BodyMode.Held : BodyMode.Free;
            using var whole = new CarriedBody(mode);
            using var parts = new CarriedBody(mode);
            foreach (CarriedBody insect in new[] { whole, parts })
            {
                insect.Body.aid = 0.7f;
                insect.Body.velocity = new float3(0.3f, -1f, 0.5f);
                insect.Body.spin = new float3(1f, 2f, -3f);
                insect.Body.rotation = quaternion.AxisAngle(math.normalize(new float3(1f, 0.2f, 1f)), 1f);
            }

            for (int step = 0; step < 5; step++)
            {
                whole.world.Step(0.04f);
                int count = whole.world.Read(whole.right).Substeps;
                Assert.That(count, Is.GreaterThan(3));
                float3 force = default, moment = default;
                float3x3 damping = default;
                float power = 0f, aid = 0f;
                for (int k = 0; k < count; k++)
                {
                    parts.world.StepOnce(0.04f / count);
                    FlyingBody body = parts.Body;
                    force += body.force / count;
                    moment += body.moment / count;
                    damping += body.damping * (1f / count);
                    power += body.power / count;
                    aid += body.aidPower / count;
                }

                FlyingBody read = whole.Body;
                Assert.That(read.position, Is.EqualTo(parts.Body.position), "both are flown the same");
                Assert.That(math.distance(read.force, force), Is.LessThan(1e-4f * math.length(force)));
                Assert.That(math.distance(read.moment, moment), Is.LessThan(1e-4f * math.length(moment)));
                Assert.That(read.power, Is.EqualTo(power).Within(1e-4f * math.abs(power)));
                Assert.That(read.aidPower, Is.EqualTo(aid).Within(1e-4f * math.abs(aid)));
                for (int column = 0; column < 3; column++)
                {
                    Assert.That(math.distance(read.damping[column], damping[column]),
                        Is.LessThanOrEqualTo(1e-4f * math.length(damping[column])));
                }

                Assert.That(power, Is.Not.Zero);
                Assert.That(aid, !held ? Is.Not.Zero : Is.Zero);
                Assert.That(math.length(damping.c0), held ? Is.Not.Zero : Is.Zero);
            }
        }

        [Test]
        public void AFreeBody_GainsTheMomentumOfItsForces()
        {
            using var insect = new CarriedBody(BodyMode.Free);
            float3 start = insect.Body.velocity = new float3(0.2f, 0.1f, 1f), impulse = default;
            for (int step = 0; step < 50; step++)
            {
                insect.world.Step(0.004f);
                impulse += 0.004f * (insect.Body.force + CarriedBody.Mass * insect.Body.weight);
            }

            Assert.That(math.distance(CarriedBody.Mass * (insect.Body.velocity - start), impulse),
                Is.LessThan(1e-3f * math.length(impulse)));
        }

        // Within a step the reference goes on with its rates.
        [Test]
        public void TheReference_GoesOnWithinAStep([Values(WingDetail.Full, WingDetail.WavesOnly)] WingDetail detail)
        {
            using var insect = new CarriedBody(BodyMode.Free);
            SetDetail(insect, detail);
            insect.Body.reference = new BodyReference
            {
                velocity = new float3(1f, 0f, 0f),
                acceleration = new float3(1f, 2f, 3f),
                heading = 0.3f,
                turning = -2f
            };
            for (int step = 0; step < 5; step++)
                insect.world.Step(0.02f);
            Assert.That(math.distance(insect.Body.reference.velocity, new float3(1.1f, 0.2f, 0.3f)), Is.LessThan(1e-5f));
            Assert.That(insect.Body.reference.heading, Is.EqualTo(0.1f).Within(1e-5f));
        }

        // Where nobody computes its wings a body follows its reference at 5 per second, in the trimmed attitude, and forgets what it had
        // measured.
        [Test]
        public void ABodyOutOfSight_FollowsItsReference()
        {
            using var insect = new CarriedBody(BodyMode.Free);
            SetDetail(insect, WingDetail.WavesOnly);
            insect.Body.reference = new BodyReference { velocity = new float3(1f, 0f, 0.5f), heading = 0.4f };
            insect.Body.integral = 0.3f;
            insect.Body.tilt = 2f;
            for (int step = 0; step < 20; step++)
                insect.world.Step(0.01f);
            float left = math.exp(-1f);
            Assert.That(math.distance(insect.Body.velocity, (1f - left) * insect.Body.reference.velocity), Is.LessThan(1e-5f));
            Assert.That(math.distance(insect.Body.position, (0.2f - 0.2f * (1f - left)) * insect.Body.reference.velocity),
                Is.LessThan(2e-4f));
            Assert.That(math.length(insect.Body.integral) + insect.Body.tilt, Is.Zero);
            float phase = insect.world.Read(insect.right).Phase;
            quaternion trimmed = math.mul(quaternion.AxisAngle(new float3(0f, 1f, 0f), 0.4f),
                quaternion.AxisAngle(new float3(1f, 0f, 0f), 0.1f * math.cos(phase) - 0.5f));
            Assert.That(math.abs(math.dot(trimmed.value, insect.Body.rotation.value)), Is.EqualTo(1f).Within(1e-6f));
        }

        // Its wings settle for the beat under way and a whole one, then carry it from where it has got to. A beat that is over before a
        // whole substep has passed does not count.
        [Test]
        public void ABodyThatComesIntoSight_IsCarriedOnceItsWingsHaveSettled()
        {
            const int phases = 50;
            const float h = 1f / (24f * CarriedBody.Frequency);
            for (int k = 0; k < phases; k++)
            {
                using var insect = new CarriedBody(BodyMode.Free);
                SetDetail(insect, WingDetail.WavesOnly);
                insect.Body.reference = new BodyReference { velocity = new float3(0f, 0f, 1f) };
                for (int step = 0; step < 100; step++)
                    insect.world.Step(0.02f);
                SetDetail(insect, WingDetail.Full);
                float phase = insect.world.Read(insect.right).Phase / (2f * math.PI), wanted = (k + 0.3f) / phases;
                foreach (WingHandle wing in new[] { insect.right, insect.left })
                    insect.world.Resume(wing, math.frac(wanted - phase + 1f) / insect.world.Read(insect.right).Frequency);
                int from = insect.world.Read(insect.right).Beats, beats = 0;
                while (insect.Body.follows != 0)
                {
                    Assert.That(math.distance(insect.Body.velocity, insect.Body.reference.velocity), Is.LessThan(1e-3f));
                    insect.world.StepOnce(h);
                    beats = insect.world.Read(insect.right).Beats - from;
                    Assert.That(beats, Is.LessThan(5));
                }

                Assert.That(beats, wanted < 1f - 1.5f / 24f ? Is.EqualTo(2) : Is.InRange(2, 3), $"from phase {wanted:F2}");
                float3 velocity = insect.Body.velocity;
                insect.world.StepOnce(h);
                Assert.That(math.distance(insect.Body.velocity, velocity), Is.InRange(1e-4f, 0.2f), "carried by its wings, and not thrown");
            }
        }

        [Test]
        public void ABodyAtRest_IsNotMoved_AndItsWingsMeetStillAir()
        {
            using var insect = new CarriedBody(BodyMode.Resting);
            insect.Body.wind = new float3(0f, 0f, -1f);
            for (int step = 0; step < 10; step++)
                insect.world.Step(0.02f);
            Assert.That(math.length(insect.Body.position) + math.length(insect.Body.velocity), Is.Zero);
            Assert.That(insect.Body.rotation, Is.EqualTo(quaternion.identity));
        }

        // Of the wings that carry one body the one that needs most says how many substeps all take.
        [Test]
        public void WingsOfABody_TakeAsManySubsteps_AsTheOneThatNeedsMost([Values] bool first)
        {
            using var insect = new CarriedBody(BodyMode.Resting);
            WingParameters fine = Monarch.Parameters;
            fine.substepsPerBeat = 97;
            insect.world.SetParameters(first ? insect.right : insect.left, fine);
            WingRig rig = Monarch.Rig(32);
            WingHandle alone = insect.world.Add(rig, fine);
            rig.Release();
            insect.world.Step(0.03f);
            int most = insect.world.Read(alone).Substeps;
            Assert.That(most, Is.GreaterThan(25));
            Assert.That(insect.world.Read(insect.right).Substeps, Is.EqualTo(most));
            Assert.That(insect.world.Read(insect.left).Substeps, Is.EqualTo(most));
            Assert.That(insect.world.Read(insect.left).Phase, Is.EqualTo(insect.world.Read(alone).Phase).Within(1e-4f));
        }

        // One latch, one command, one beat; the command is made once, just before the beat that it is for.
        [Test]
        public void EveryBeat_IsCommandedOnce([Values(0.004f, 0.02f)] float dt)
        {
            using var insect = new CarriedBody(BodyMode.Free);
            insect.Body.weight = default;
            for (int step = 0; step * dt < 1f; step++)
            {
                insect.world.Step(dt);
                Assert.That(insect.Body.beats - insect.world.Read(insect.right).Beats, Is.InRange(0, 1));
            }

            Assert.That(insect.Body.beats, Is.InRange(10, 12));
        }

        [Test]
        public void ABodyThatForgets_IsAsANewOne()
        {
            FlyingBody body = default;
            body.integral = body.velocityError = body.turnError = body.rateError = body.force = body.moment = 1f;
            body.tilt = body.aidPower = body.power = body.sinceSample = 1f;
            body.latched = body.clipped = 1;
            for (int k = 0; k < FlightCommands.Count; k++)
                SetLast(ref body, k);
            body.Forget();
            for (int k = 0; k < FlightCommands.Count; k++)
                Assert.That(body.Last(k), Is.Zero);
            float3 sum = body.integral + body.velocityError + body.turnError + body.rateError + body.force + body.moment;
            Assert.That(math.length(sum) + body.tilt + body.aidPower + body.power + body.sinceSample + body.latched + body.clipped,
                Is.Zero);
        }

        private static void SetDetail(CarriedBody insect, WingDetail detail)
        {
            insect.world.SetDetail(insect.right, detail);
            insect.world.SetDetail(insect.left, detail);
        }

        private static unsafe void SetLast(ref FlyingBody body, int command) => body.last[command] = 1f;
    }
}
