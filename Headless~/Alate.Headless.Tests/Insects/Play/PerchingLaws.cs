using System.Collections;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Ways down to a spot, stays on it and pushes off it, step by step, by their closed forms. Metres of an insect.</summary>
    public sealed class PerchingLaws : PerchingFixture
    {
        private const float k_Clearance = 0.06f;

        // Up to where a downstroke clears the surface while the beat under way ends, then down by a smooth step; on along the surface by
        // one over all the time, with the motion that it brings along; turned within seven tenths of it.
        [UnityTest]
        public IEnumerator TheWayDown_IsASmoothStep_OnceTheWingsAreRaised(
            [Values(0.02f, 0.055f, 0.2f, 1f)] float height, [Values(0f, 0.3f, 2f, -0.6f)] float speed, [Values(1f, 10f)] float units)
        {
            float3 normal = math.normalize(new float3(0.3f, 1f, -0.2f));
            var spot = new PerchSpot { position = Spot, normal = normal, heading = 0.7f };
            float3 away = math.cross(normal, new float3(0f, 0f, 1f)), from = Spot + units * (height * normal + 0.1f * away);
            quaternion turned = math.mul(quaternion.RotateY(2f), quaternion.RotateX(0.5f));
            float3 velocity = speed * math.normalize(new float3(-0.4f, -1f, 0.5f));
            FlyingBody body = default;
            body.rotation = turned;
            body.velocity = velocity;
            float3 legs = units * Legs, centre = from - math.rotate(turned, legs);
            var perching = new Perching(ref body, spot, centre, legs, k_Clearance, Wings.Frequency, units);
            AssertHeld(body);
            Assert.That((perching.Holds, perching.IsSeated), Is.EqualTo((true, false)));

            float rise = math.max(k_Clearance - height, 0f);
            float raising = math.min(math.max(1f / Wings.Frequency, 1.5f * rise / 0.25f), 0.3f);
            float3 brought = velocity - math.min(math.dot(velocity, normal), 0f) * normal;
            float way = math.distance(from + units * rise * normal, Spot) / units;
            quaternion seat = Facing(0.7f, normal);
            float time = raising + math.clamp(1.5f * way / math.max(0.25f, math.length(brought)), 0.2f, 1.5f)
                + 2f * math.acos(math.min(math.abs(math.dot(turned, seat)), 1f)) / 6f;
            brought *= math.min(1f, 1.5f * way / math.max(math.length(brought) * time, 1e-6f));
            int steps = 0;
            while (!perching.IsSeated)
            {
                perching.Sit(ref body, Wings, StepLength);
                float now = ++steps * StepLength, share = math.saturate(now / time);
                float top = math.max(height, k_Clearance);
                float over = now < raising
                    ? math.lerp(height, top, math.smoothstep(0f, 1f, now / raising))
                    : top * (1f - math.smoothstep(0f, 1f, (now - raising) / (time - raising)));
                float3 feet = Spot + units * (over * normal + 0.1f * (1f - math.smoothstep(0f, 1f, share)) * away
                    + brought * time * share * (1f - share) * (1f - share));
                Assert.That(math.distance(perching.Centre(body.rotation, legs) + math.rotate(body.rotation, legs), feet),
                    Is.LessThan(2e-5f * units), $"{now} s of {time}");
                AssertTurned(body.rotation, turned, seat, math.smoothstep(0f, 1f, share / 0.7f));
                AssertHeld(body);
                Assert.That(steps, Is.LessThan(1000));
            }

            Assert.That(steps * StepLength, Is.InRange(time - 1e-4f, time + StepLength + 1e-4f));
            Assert.That(World.Drive(Live.wings[0].handle).amplitude, Is.Zero, "the wings come to rest");
            yield break;
        }

        // The wings get going for three beats, during which the insect turns on its feet; then the legs push: evenly faster or slower, and
        // on with the speed of the jump.
        [UnityTest]
        public IEnumerator APush_EndsWithTheJump_OverTheClearance(
            [Values(0f, 0.6f)] float slope, [Values(float.NaN, 1.2f)] float heading, [Values(1f, 10f)] float units,
            [Values(0.03f, k_Clearance)] float clearance)
        {
            var normal = new float3(math.sin(slope), math.cos(slope), 0f);
            Perching perching = Seated(normal, 0f, clearance, units, out FlyingBody sitting);
            ref FlyingBody body = ref World.Body(new BodyHandle(0, 1));
            body.rotation = sitting.rotation;
            float frequency = Wings.Frequency, time = 0f;
            float3 up = math.normalize(normal + new float3(0f, 1f, 0f)), feet = Spot;
            int steps = 0;
            while (perching.IsSeated)
            {
                quaternion before = body.rotation;
                perching.Start(ref body, Wings, heading, StepLength);
                time = ++steps * StepLength;
                if (!perching.IsSeated)
                    break;
                Assert.That(math.distance(Feet(perching, body, units), feet), Is.LessThan(1e-5f * units), "it stands");
                float turn = 2f * math.acos(math.min(math.abs(math.dot(before, body.rotation)), 1f));
                Assert.That(turn, Is.LessThan(6f * StepLength + 2e-3f));
                Assert.That(math.distance(math.rotate(body.rotation, new float3(0f, 1f, 0f)), normal), Is.LessThan(1e-4f), "on its feet");
                AssertHeld(body);
                WingDrive drive = World.Drive(Live.wings[0].handle), hover = Table.DriveNear(0f, 0f);
                Assert.That((drive.frequency, drive.amplitude), Is.EqualTo((hover.frequency, 0.45f * hover.amplitude)));
                WingParameters parameters = Model.Wings[0].Parameters;
                Assert.That(drive.meanFlap,
                    Is.EqualTo(0.55f * hover.amplitude * parameters.amplitude.x * parameters.amplitudeScale).Within(1e-6f));
            }

            Assert.That(time, Is.InRange(3f / frequency, 3f / frequency + StepLength + 1e-4f), "three beats");
            if (math.isfinite(heading))
                Assert.That(Headings.Wrap(body.reference.heading - Headings.Of(Facing(heading, normal))), Is.Zero.Within(1e-3f));
            float way = 1.45f * clearance / math.dot(up, normal);
            float pushing = math.max(math.max(2f * way / 0.8f, 0.12f), 2f / frequency), first = 2f * way / pushing - 0.2f;
            float pushed = math.min(time - 3f / frequency, StepLength);
            bool beatsWhole = false;
            while (perching.Holds)
            {
                float at = math.min(pushed, pushing);
                float3 place = Spot
                    + units * (first * at + 0.5f * (0.2f - first) * at * at / pushing + 0.2f * math.max(pushed - pushing, 0f)) * up;
                Assert.That(math.distance(Feet(perching, body, units), place), Is.LessThan(2e-5f * units), $"{pushed} s of {pushing}");
                AssertHeld(body);
                beatsWhole |= (pushing - pushed) * frequency < 0.5f;
                WingDrive drive = World.Drive(Live.wings[0].handle);
                Assert.That(drive.amplitude, Is.EqualTo((beatsWhole ? 1f : 0.45f) * Table.DriveNear(0f, 0f).amplitude));
                perching.Start(ref body, Wings, heading, StepLength);
                pushed += StepLength;
                Assert.That(pushed, Is.LessThan(3f));
            }

            // Wings that nobody computes do not beat: after four beats it flies on all the same.
            Assert.That(pushed - StepLength - pushing, Is.InRange(4f / frequency, 4f / frequency + StepLength + 1e-4f));
            Assert.That(math.distance(perching.Jump, 0.2f * up), Is.LessThan(1e-6f));
            yield break;
        }

        // Its body goes over from the stand to the bob of hovering within the push.
        [UnityTest]
        public IEnumerator WhilePushed_TheBodyTurns_FromItsSeatToItsBob()
        {
            float3 normal = math.normalize(new float3(0.4f, 1f, 0.3f));
            Perching perching = Seated(normal, 1f, k_Clearance, 1f, out FlyingBody sitting);
            ref FlyingBody body = ref World.Body(new BodyHandle(0, 1));
            body.rotation = sitting.rotation;
            while (perching.IsSeated)
                perching.Start(ref body, Wings, float.NaN, StepLength);
            float way = 1.45f * k_Clearance / math.dot(math.normalize(normal + new float3(0f, 1f, 0f)), normal);
            float pushing = math.max(math.max(2f * way / 0.8f, 0.12f), 2f / Wings.Frequency), time = 0f, before = -1f;
            while (time < pushing)
            {
                quaternion bob = Bob(sitting.rotation);
                perching.Start(ref body, Wings, float.NaN, StepLength);
                time += StepLength;
                float gone = Angle(sitting.rotation, body.rotation), all = Angle(sitting.rotation, bob);
                Assert.That(gone + Angle(body.rotation, bob), Is.EqualTo(all).Within(3e-3f), "on the way between the two");
                Assert.That(gone, Is.GreaterThan(before - 1e-3f));
                before = gone;
            }

            Assert.That(Angle(body.rotation, Bob(sitting.rotation)), Is.LessThan(5e-3f));
            yield break;
        }

        // One that never gets to its heading is pushed off after a second.
        [UnityTest]
        public IEnumerator OneThatTurnsAndTurns_StandsASecond()
        {
            Perching perching = Seated(new float3(0f, 1f, 0f), 0f, k_Clearance, 1f, out FlyingBody sitting);
            ref FlyingBody body = ref World.Body(new BodyHandle(0, 1));
            body.rotation = sitting.rotation;
            int steps = 0;
            for (; perching.IsSeated; steps++)
                perching.Start(ref body, Wings, Headings.Of(body.rotation) + (steps % 20 < 10 ? 1f : -1f), StepLength);
            Assert.That(steps * StepLength, Is.EqualTo(1f).Within(1.5f * StepLength));
            yield break;
        }

        // Beaten wholly twice, and in the last three tenths of a beat; in the attitude in which it was held last, its bob at the end of the
        // step.
        [UnityTest]
        public IEnumerator WhoseWingsBeat_FliesOff_WithRaisedWings()
        {
            Perching perching = Seated(new float3(0f, 1f, 0f), 0f, k_Clearance, 1f, out FlyingBody sitting);
            ref FlyingBody body = ref World.Body(new BodyHandle(0, 1));
            body.rotation = sitting.rotation;
            float whole = Table.DriveNear(0f, 0f).amplitude;
            int from = -1;
            quaternion held = default;
            for (int step = 0; perching.Holds; step++)
            {
                held = body.rotation;
                perching.Start(ref body, Wings, float.NaN, StepLength);
                if (from < 0 && World.Drive(Live.wings[0].handle).amplitude == whole)
                    from = Wings.Beats;
                if (perching.Holds)
                    World.Step(StepLength);
                Assert.That(step, Is.LessThan(400));
            }

            Assert.That(Wings.Beats, Is.EqualTo(from + 2));
            Assert.That(Wings.Phase, Is.InRange(0.7f, 0.7f + 1.1f * StepLength * Wings.Frequency));
            Assert.That(Angle(held, body.rotation), Is.LessThan(5e-3f));
            yield break;
        }

        // Whoever carries the spot carries the way: a twin that is carried at any moment is where the other is, moved and turned.
        [UnityTest]
        public IEnumerator ACarriedOne_IsWhereTheOtherIs_MovedAndTurned([Values(0, 20, 60, 400)] int steps, [Values] bool starts)
        {
            float3 normal = math.normalize(new float3(0.3f, 1f, 0.1f));
            float3 from = new float3(0.5f, 1f, -2f), to = new float3(-4f, 2f, 6f);
            var turn = quaternion.AxisAngle(new float3(0f, 1f, 0f), 0.9f);
            FlyingBody body = default, other;
            body.rotation = quaternion.AxisAngle(new float3(0f, 1f, 0f), -1f);
            body.velocity = new float3(0.2f, 0.1f, -0.3f);
            var perching = new Perching(ref body, new PerchSpot { position = Spot, normal = normal, heading = 0.7f },
                Spot + new float3(0.1f, 0.3f, 0.2f), Legs, k_Clearance, Wings.Frequency, 1f);
            for (int step = 0; step < steps; step++)
                perching.Sit(ref body, Wings, StepLength);
            for (int step = 0; starts && step < 10; step++)
                perching.Start(ref body, Wings, float.NaN, StepLength);
            Perching carried = perching;
            other = body;
            other.rotation = math.mul(turn, other.rotation);
            carried.Carry(from, to, turn);
            for (int step = 0; step < 100; step++)
            {
                Assert.That(math.distance(Feet(carried, other, 1f), to + math.rotate(turn, Feet(perching, body, 1f) - from)),
                    Is.LessThan(2e-5f), $"step {step}");
                if (!starts)
                    Assert.That(Angle(other.rotation, math.mul(turn, body.rotation)), Is.LessThan(2e-3f), $"step {step}");
                if (starts)
                {
                    perching.Start(ref body, Wings, float.NaN, StepLength);
                    carried.Start(ref other, Wings, float.NaN, StepLength);
                }
                else
                {
                    perching.Sit(ref body, Wings, StepLength);
                    carried.Sit(ref other, Wings, StepLength);
                }
            }

            Assert.That(math.distance(carried.Jump, math.rotate(turn, perching.Jump)), Is.LessThan(1e-6f));
            yield break;
        }

        // Called back while its wings beat wholly it stays up for a beat, in which they are raised; before that it sinks at once.
        [UnityTest]
        public IEnumerator CalledBack_ItStaysUp_OnlyWhereTheWingsBeatWholly([Values] bool whole)
        {
            Perching perching = Seated(new float3(0f, 1f, 0f), 0f, k_Clearance, 1f, out FlyingBody body);
            for (int step = 0; whole ? !IsWhole() : perching.IsSeated || Feet(perching, body, 1f).y < Spot.y + 0.02f; step++)
            {
                perching.Start(ref body, Wings, float.NaN, StepLength);
                Assert.That(step, Is.LessThan(400));
            }

            float height = Feet(perching, body, 1f).y - Spot.y, raising = whole ? 1f / Wings.Frequency : 0f;
            float time = raising + math.clamp(1.5f * height / 0.25f, 0.2f, 1.5f)
                + Angle(body.rotation, quaternion.identity) / 6f;
            for (float now = StepLength; now < time; now += StepLength)
            {
                perching.Sit(ref body, Wings, StepLength);
                float over = height * (1f - math.smoothstep(0f, 1f, (now - raising) / (time - raising)));
                Assert.That(Feet(perching, body, 1f).y - Spot.y, Is.EqualTo(over).Within(2e-4f), $"{now} s of {time}");
            }

            yield break;
        }

        // Where the heading leads into a wall it looks along the wall.
        [UnityTest]
        public IEnumerator OnAWall_ItLooksAlongIt([Values(0f, 0.5f, 1f, 1.5f)] float quarters, [Values(0f, 0.5f, 1f)] float headingOff)
        {
            float course = 0.5f * math.PI * quarters;
            var normal = new float3(math.sin(course), 0f, math.cos(course));
            Perching perching = Seated(normal, course + headingOff, k_Clearance, 1f, out FlyingBody body);
            Assert.That(math.distance(math.rotate(body.rotation, new float3(0f, 1f, 0f)), normal), Is.LessThan(1e-3f));
            float3 ahead = math.rotate(body.rotation, new float3(0f, 0f, 1f));
            if (headingOff > 0f)
                Assert.That(math.dot(ahead, new float3(math.cos(course), 0f, -math.sin(course))), Is.EqualTo(1f).Within(1e-3f));
            Assert.That(math.length(ahead), Is.EqualTo(1f).Within(1e-4f));
            Assert.That(perching.IsSeated);
            yield break;
        }

        private bool IsWhole() => World.Drive(Live.wings[0].handle).amplitude == Table.DriveNear(0f, 0f).amplitude;
    }
}
