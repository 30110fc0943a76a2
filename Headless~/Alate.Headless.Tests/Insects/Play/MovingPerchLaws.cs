using System.Collections;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects on a perch that moves, and below ceilings, by their closed forms. Metres of an insect.</summary>
    public sealed class MovingPerchLaws : PerchingFixture
    {
        private const float k_Clearance = 0.06f;

        // Of what turns about one axis the feet, the back and the nose go along, as those of a rigid body.
        [UnityTest]
        public IEnumerator WhoSits_GoesAlong_AsIfPinned([Values(1f, 10f)] float units, [Values(0f, 0.5f)] float slope)
        {
            var normal = new float3(math.sin(slope), math.cos(slope), 0f);
            Perching perching = Seated(normal, 0f, k_Clearance, units, out FlyingBody body);
            quaternion seat = body.rotation;
            for (int step = 1; step <= 200; step++)
            {
                float time = step * StepLength;
                float3 place = Spot + units * new float3(0.05f * math.sin(6f * time), 0.02f * time, -0.03f * time);
                var tilt = quaternion.AxisAngle(math.normalize(new float3(1f, 0f, 2f)), 0.3f * math.sin(5f * time));
                float3 leaning = math.rotate(tilt, normal);
                perching.Follow(ref body, new PerchSpot { position = place, normal = 3f * leaning, heading = float.NaN });
                perching.Sit(ref body, Wings, StepLength);
                Assert.That(perching.IsSeated);
                Assert.That(math.distance(Feet(perching, body, units), place), Is.LessThan(1e-5f * units), $"{time} s");
                Assert.That(math.distance(math.rotate(body.rotation, new float3(0f, 1f, 0f)), leaning), Is.LessThan(1e-4f), $"{time} s");
            }

            perching.Follow(ref body, new PerchSpot { position = Spot, normal = normal, heading = float.NaN });
            Assert.That(Angle(seat, body.rotation), Is.LessThan(0.05f), "as it was, but for what turns on turns leave about the normal");
            yield break;
        }

        [UnityTest]
        public IEnumerator OnATurntable_ItTurnsAlong([Values(-0.7f, 1.2f)] float turn)
        {
            Perching perching = Seated(new float3(0f, 1f, 0f), 0.4f, k_Clearance, 1f, out FlyingBody body);
            perching.Follow(ref body, new PerchSpot { position = Spot, normal = new float3(0f, 1f, 0f), heading = 0.4f });
            Assert.That(Headings.Of(body.rotation), Is.EqualTo(0.4f).Within(1e-4f));
            perching.Follow(ref body, new PerchSpot { position = Spot, normal = new float3(0f, 1f, 0f), heading = 0.4f + turn });
            Assert.That(Headings.Of(body.rotation), Is.EqualTo(0.4f + turn).Within(1e-4f));
            yield break;
        }

        // A pilot that names another spot does not drag the insect there.
        [UnityTest]
        public IEnumerator AnotherSpot_DoesNotTakeItAlong([Values(0.19f, 0.21f)] float way, [Values(1f, 10f)] float units)
        {
            var up = new float3(0f, 1f, 0f);
            Perching perching = Seated(up, 0f, k_Clearance, units, out FlyingBody body);
            var spot = new PerchSpot { position = Spot + new float3(way * units, 0f, 0f), normal = up, heading = 0f };
            quaternion rotation = body.rotation;
            float3 centre = perching.Centre(rotation, units * Legs), before = centre;
            perching.Show(spot, 1f, ref rotation, ref centre);
            Assert.That(math.distance(centre, before), Is.EqualTo(way < 0.2f ? way * units : 0f).Within(1e-5f * units));
            perching.Follow(ref body, spot);
            Assert.That(math.distance(Feet(perching, body, units), Spot), Is.EqualTo(way < 0.2f ? way * units : 0f).Within(1e-5f * units));
            spot.position += new float3(0f, 0f, 0.05f * units);
            perching.Follow(ref body, spot);
            float along = Feet(perching, body, units).z - Spot.z;
            Assert.That(along, Is.EqualTo(0.05f * units).Within(1e-5f * units), "from there on it goes along");
            yield break;
        }

        // Over a surface that goes up and down the way down is that over one that stays.
        [UnityTest]
        public IEnumerator OnTheWayDown_TheHeightIsThatOverAPerchThatStays([Values(0.3f, -0.3f)] float speed)
        {
            var up = new float3(0f, 1f, 0f);
            var spot = new PerchSpot { position = Spot, normal = up, heading = 0f };
            FlyingBody still = default, moved = default;
            still.rotation = moved.rotation = quaternion.identity;
            float3 centre = Spot + 0.1f * up - Legs;
            var one = new Perching(ref still, spot, centre, Legs, k_Clearance, Wings.Frequency, 1f);
            var other = new Perching(ref moved, spot, centre, Legs, k_Clearance, Wings.Frequency, 1f);
            for (int step = 1; !one.IsSeated; step++)
            {
                spot.position += new float3(0.2f, speed, 0f) * StepLength;
                other.Follow(ref moved, spot);
                one.Sit(ref still, Wings, StepLength);
                other.Sit(ref moved, Wings, StepLength);
                float over = Feet(one, still, 1f).y - Spot.y, overMoved = Feet(other, moved, 1f).y - spot.position.y;
                if (step * StepLength > 0.3f)
                    Assert.That(overMoved, Is.EqualTo(over).Within(1e-5f), $"{step * StepLength} s");
                Assert.That(overMoved, Is.GreaterThan(-1e-6f));
                Assert.That(step, Is.LessThan(1000));
            }

            Assert.That(other.IsSeated);
            Assert.That(math.distance(Feet(other, moved, 1f), spot.position), Is.LessThan(1e-6f));
            yield break;
        }

        // To the bit: what is told and has not moved changes nothing.
        [UnityTest]
        public IEnumerator APerchThatStays_IsAsIfItWereNotTold()
        {
            float3 normal = math.normalize(new float3(0.3f, 1f, -0.2f));
            Perching told = Seated(normal, 0.7f, k_Clearance, 1f, out FlyingBody body), untold = told;
            FlyingBody other = body;
            for (int step = 0; step < 200; step++)
            {
                told.Follow(ref body, new PerchSpot { position = Spot, normal = normal, heading = 0.7f });
                told.Start(ref body, Wings, 1f, StepLength);
                untold.Start(ref other, Wings, 1f, StepLength);
                Assert.That(body.rotation, Is.EqualTo(other.rotation));
                Assert.That(told.Centre(body.rotation, Legs), Is.EqualTo(untold.Centre(other.rotation, Legs)));
            }

            yield break;
        }

        // It stands, goes along, and leaves where the perch begins to sink, or after 1.2 s of what only rises.
        [UnityTest]
        public IEnumerator APush_BeginsWhereThePerchIsHighest([Values(0f, 0.25f, 0.5f, 0.8f)] float phase)
        {
            var up = new float3(0f, 1f, 0f);
            Perching perching = Seated(up, 0f, k_Clearance, 1f, out FlyingBody body);
            float time = 0f;
            while (perching.IsSeated)
            {
                time += StepLength;
                perching.Follow(ref body, Swaying(phase + time));
                perching.Start(ref body, Wings, float.NaN, StepLength);
                Assert.That(time, Is.LessThan(3f));
            }

            float least = 3f / Wings.Frequency, top = math.ceil(phase + least - 0.25f) + 0.25f - phase;
            Assert.That(time, Is.EqualTo(top).Within(2f * StepLength));
            yield break;
        }

        [UnityTest]
        public IEnumerator OffAPerchThatOnlyRises_ItPushesIntoTheRise()
        {
            var up = new float3(0f, 1f, 0f);
            Perching perching = Seated(up, 0f, k_Clearance, 1f, out FlyingBody body);
            float time = 0f, least = 3f / Wings.Frequency;
            PerchSpot spot = Swaying(0f);
            while (perching.IsSeated)
            {
                time += StepLength;
                spot.position += 0.1f * StepLength * up;
                perching.Follow(ref body, spot);
                perching.Start(ref body, Wings, float.NaN, StepLength);
                Assert.That(time, Is.LessThan(3f));
            }

            Assert.That(time, Is.EqualTo(least + 1.2f).Within(2f * StepLength));
            float over = Feet(perching, body, 1f).y - spot.position.y;
            for (int step = 0; step < 20; step++)
            {
                spot.position += 0.1f * StepLength * up;
                perching.Follow(ref body, spot);
                perching.Start(ref body, Wings, float.NaN, StepLength);
                float now = Feet(perching, body, 1f).y - spot.position.y;
                Assert.That(now, Is.GreaterThan(over), "the legs push it off what rises");
                over = now;
            }

            yield break;
        }

        // Between steps, as it is drawn.
        [UnityTest]
        public IEnumerator BetweenSteps_WhoSitsIsDrawnOnThePerch()
        {
            float3 normal = math.normalize(new float3(0.2f, 1f, 0f));
            Perching perching = Seated(normal, 0f, k_Clearance, 1f, out FlyingBody body);
            quaternion rotation = body.rotation;
            float3 centre = perching.Centre(rotation, Legs), way = new float3(0.01f, -0.02f, 0.03f);
            float3 leaning = math.normalize(normal + new float3(0f, 0f, 0.1f));
            perching.Show(new PerchSpot { position = Spot + way, normal = leaning, heading = float.NaN }, 1f, ref rotation, ref centre);
            Assert.That(math.distance(centre + math.rotate(rotation, Legs), Spot + way), Is.LessThan(1e-6f));
            Assert.That(math.distance(math.rotate(rotation, new float3(0f, 1f, 0f)), leaning), Is.LessThan(1e-5f));
            yield break;
        }

        // Upside down before it nears a ceiling; off it down, and upright only when it is away.
        [UnityTest]
        public IEnumerator BelowACeiling_ItTurnsOver_WhereItHasRoom()
        {
            var down = new float3(0f, -1f, 0f);
            var spot = new PerchSpot { position = Spot, normal = down, heading = 0f };
            FlyingBody body = default;
            body.rotation = quaternion.identity;
            var perching = new Perching(ref body, spot, Spot + 0.1f * down - Legs, Legs, k_Clearance, Wings.Frequency, 1f);
            while (!perching.IsSeated)
            {
                perching.Sit(ref body, Wings, StepLength);
                float below = Spot.y - Feet(perching, body, 1f).y, upright = math.rotate(body.rotation, new float3(0f, 1f, 0f)).y;
                Assert.That(upright < -0.5f || below > k_Clearance, $"{below} m below, {upright}");
            }

            Assert.That(math.distance(math.rotate(body.rotation, new float3(0f, 1f, 0f)), down), Is.LessThan(1e-4f));
            Assert.That(math.distance(perching.Jump, 0.2f * down), Is.LessThan(1e-6f));
            while (perching.Holds)
            {
                if (!perching.IsSeated)
                    body.rotation = quaternion.identity;
                perching.Start(ref body, Wings, float.NaN, StepLength);
                float below = Spot.y - Feet(perching, body, 1f).y, upright = math.rotate(body.rotation, new float3(0f, 1f, 0f)).y;
                Assert.That(upright < 0.1f || below > 1.3f * k_Clearance, $"{below} m below, {upright}");
            }

            Assert.That(Spot.y - Feet(perching, body, 1f).y, Is.GreaterThan(1.7f * k_Clearance));
            yield break;
        }

        private static PerchSpot Swaying(float time) => new()
        {
            position = Spot + new float3(0f, 0.05f * math.sin(2f * math.PI * time), 0f),
            normal = new float3(0f, 1f, 0f),
            heading = 0f,
        };
    }
}
