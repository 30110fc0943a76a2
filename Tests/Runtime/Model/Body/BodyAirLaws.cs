using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>
    /// Air that a wing on a body meets, and the force that it gives back: one air in both frames, right wings and left ones.
    /// </summary>
    public sealed unsafe class BodyAirLaws
    {
        // Air that any point of a wing meets, less what the body moves by: seen from the wing, in its lengths, it is the same.
        [Test]
        public void EveryPointOfAWing_MeetsTheAirThatItMeetsOnTheBody([Values(1u, 2u, 3u, 4u)] uint seed, [Values(false, true)] bool left)
        {
            var random = Random.CreateFromIndex(seed);
            using var pack = new PackFixture(Monarch.Rig(16), Monarch.Parameters);
            FlyingBody body = Body(ref random);
            BodyWing wing = Wing(ref random, left);
            wing.lane = 2;
            wing.firstCopy = wing.endCopy = 4;
            BodyAir.Surround(body, wing, pack.Pack);
            LaneSurroundings* met = pack.Pack.surroundings;
            float3 wind = met->wind[2], spin = met->angularVelocity[2], hinge = met->hinge[2];
            quaternion back = math.conjugate(body.middleRotation);
            for (int k = 0; k < 10; k++)
            {
                float3 point = random.NextFloat3(-1f, 1f), onBody = wing.hinge + wing.length * math.mul(wing.axes, point);
                float3 air = math.rotate(back, body.wind - body.middleVelocity) - math.cross(body.middleSpin, onBody);
                Assert.That(math.distance(wing.length * math.mul(wing.axes, wind - math.cross(spin, hinge + point)), air),
                    Is.LessThan(1e-5f));
            }

            float3 gravity = wing.length * math.mul(wing.axes, met->gravity[2]);
            Assert.That(math.distance(gravity, wing.gravityShare * math.rotate(back, body.gravity)), Is.LessThan(1e-5f));
            Assert.That(math.length(met->wind[1]) + math.length(met->hinge[3]), Is.Zero, "the other lanes are not touched");
        }

        [Test]
        public void CopiesOfAWing_MeetWhatItMeets()
        {
            var random = Random.CreateFromIndex(3);
            using var pack = new PackFixture(Monarch.Rig(16), Monarch.Parameters);
            BodyWing wing = Wing(ref random, false);
            wing.lane = 0;
            wing.firstCopy = 2;
            wing.endCopy = 4;
            BodyAir.Surround(Body(ref random), wing, pack.Pack);
            LaneSurroundings* met = pack.Pack.surroundings;
            foreach (int lane in new[] { 2, 3 })
            {
                Assert.That(met->wind[lane], Is.EqualTo(met->wind[0]));
                Assert.That(met->angularVelocity[lane], Is.EqualTo(met->angularVelocity[0]));
            }

            Assert.That(math.length(met->wind[1]), Is.Zero);
        }

        // Force and moment do the same work on the body's motion as in the wing's frame, in its masses and lengths; so does the damping.
        [Test]
        public void ForceMomentAndDamping_DoTheSameWork([Values(1u, 2u, 3u, 4u)] uint seed, [Values(false, true)] bool left)
        {
            var random = Random.CreateFromIndex(seed);
            using var pack = new PackFixture(Monarch.Rig(16), Monarch.Parameters);
            BodyWing wing = Wing(ref random, left);
            wing.lane = 1;
            LaneAir* lanes = pack.Pack.air;
            float3 force = lanes->force[1] = random.NextFloat3(-1f, 1f), moment = lanes->moment[1] = random.NextFloat3(-1f, 1f);
            float3x3 uu = Any(ref random), uw = Any(ref random), ww = Any(ref random);
            for (int k = 0; k < 3; k++)
            {
                Column(ref lanes->uu, k)[1] = uu[k];
                Column(ref lanes->uw, k)[1] = uw[k];
                Column(ref lanes->ww, k)[1] = ww[k];
            }

            lanes->power = new float4(9f, 2f, 9f, 9f);
            BodyAir air = default;
            air.Add(wing, pack.Pack);
            float unit = wing.mass * wing.length * wing.length;
            Assert.That(air.power, Is.EqualTo(2f * unit).Within(1e-6f * unit));
            for (int k = 0; k < 10; k++)
            {
                float3 velocity = random.NextFloat3(-1f, 1f), spin = random.NextFloat3(-1f, 1f);
                float3 v = wing.ToWing(velocity) / wing.length, w = wing.ToWing(spin) * (left ? -1f : 1f);
                float work = unit * (math.dot(force, v) + math.dot(moment, w));
                Assert.That(math.dot(air.force, velocity) + math.dot(air.moment, spin),
                    Is.EqualTo(work).Within(1e-4f * unit / wing.length));
                float lost = unit * (math.dot(v, math.mul(uu, v)) + 2f * math.dot(v, math.mul(uw, w)) + math.dot(w, math.mul(ww, w)));
                air.damping.Multiply(velocity, spin, out float3 dampingForce, out float3 dampingMoment);
                Assert.That(math.dot(dampingForce, velocity) + math.dot(dampingMoment, spin),
                    Is.EqualTo(lost).Within(1e-3f * unit / (wing.length * wing.length)));
            }

            BodyAir twice = air;
            twice.Add(wing, pack.Pack);
            Assert.That(math.distance(twice.force, 2f * air.force) + math.distance(twice.moment, 2f * air.moment), Is.LessThan(1e-6f),
                "wings add up");
            Assert.That(twice.power, Is.EqualTo(2f * air.power));
            Assert.That(math.distance(twice.damping.uw.c1, 2f * air.damping.uw.c1), Is.LessThan(1e-6f));
        }

        // A mirrored wing gives the mirror image: force (−x, y, z), moment (x, −y, −z).
        [Test]
        public void AMirroredWing_GivesTheMirrorImage()
        {
            var random = Random.CreateFromIndex(8);
            using var pack = new PackFixture(Monarch.Rig(16), Monarch.Parameters);
            pack.Pack.air->force = new SoaFloat3(random.NextFloat3(-1f, 1f));
            pack.Pack.air->moment = new SoaFloat3(random.NextFloat3(-1f, 1f));
            BodyWing wing = Wing(ref random, false), mirrored = wing;
            mirrored.axes = math.mul(new float3x3(-1f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f), wing.axes);
            mirrored.handedness = -1f;
            BodyAir one = default, other = default;
            one.Add(wing, pack.Pack);
            other.Add(mirrored, pack.Pack);
            Assert.That(math.distance(other.force, new float3(-1f, 1f, 1f) * one.force), Is.LessThan(1e-9f));
            Assert.That(math.distance(other.moment, new float3(1f, -1f, -1f) * one.moment), Is.LessThan(1e-9f));
        }

        [Test]
        public void AHeldBody_ReadsForceMomentAndDampingOfItsAir([Values(0f, 0.8f)] float pitch)
        {
            var random = Random.CreateFromIndex(6);
            FlyingBody body = default;
            body.middleRotation = quaternion.AxisAngle(new float3(1f, 0f, 0f), -pitch);
            body.middleVelocity = new float3(0f, -1f, 2f);
            body.wind = new float3(1f, 0f, 0f);
            body.drag = new float3(1f, 2f, 3f);
            var air = new BodyAir { force = random.NextFloat3(-1f, 1f), moment = random.NextFloat3(-1f, 1f) };
            air.damping = new Symmetric6 { uu = Symmetric(ref random), uw = Any(ref random), ww = Symmetric(ref random) };
            BodyMotion.Read(ref body, air);
            float3 stream = math.rotate(math.conjugate(body.middleRotation), new float3(1f, 1f, -2f));
            float3 hull = math.sqrt(6f) * body.drag * stream;
            Assert.That(math.distance(body.force, math.rotate(body.middleRotation, air.force + hull)), Is.LessThan(1e-5f));
            Assert.That(body.moment, Is.EqualTo(air.moment));
            for (int column = 0; column < 3; column++)
            {
                // Velocity up, ahead along the world's axes, and turning about X: what each takes away, up, ahead and about X.
                float3 velocity = math.rotate(math.conjugate(body.middleRotation),
                    new float3(0f, column == 0 ? 1f : 0f, column == 1 ? 1f : 0f));
                var spin = new float3(column == 2 ? 1f : 0f, 0f, 0f);
                float3 force = math.rotate(body.middleRotation, math.mul(air.damping.uu, velocity) + math.mul(air.damping.uw, spin));
                float3 moment = math.mul(math.transpose(air.damping.uw), velocity) + math.mul(air.damping.ww, spin);
                Assert.That(math.distance(body.damping[column], new float3(force.y, force.z, moment.x)), Is.LessThan(1e-5f),
                    $"column {column}");
            }
        }

        [Test]
        public void SymmetricSystems_AreSolved_AsTheyAreMultiplied([Values(1u, 2u, 3u, 4u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            var matrix = new Symmetric6
            {
                uu = Symmetric(ref random) + 4f * float3x3.identity,
                uw = Any(ref random),
                ww = Symmetric(ref random) + 4f * float3x3.identity
            };
            float3 u = random.NextFloat3(-1f, 1f), w = random.NextFloat3(-1f, 1f);
            matrix.Multiply(u, w, out float3 force, out float3 moment);
            Assert.That(math.distance(force, math.mul(matrix.uu, u) + math.mul(matrix.uw, w)), Is.LessThan(1e-5f));
            Assert.That(math.distance(moment, math.mul(math.transpose(matrix.uw), u) + math.mul(matrix.ww, w)), Is.LessThan(1e-5f));
            matrix.Solve(force, moment, out float3 foundU, out float3 foundW);
            Assert.That(math.distance(foundU, u) + math.distance(foundW, w), Is.LessThan(1e-4f));
        }

        private static FlyingBody Body(ref Random random)
        {
            FlyingBody body = default;
            body.rotation = random.NextQuaternionRotation();
            body.middleRotation = random.NextQuaternionRotation();
            body.velocity = random.NextFloat3(-1f, 1f);
            body.middleVelocity = random.NextFloat3(-1f, 1f);
            body.middleSpin = random.NextFloat3(-9f, 9f);
            body.wind = random.NextFloat3(-1f, 1f);
            body.gravity = random.NextFloat3(-9f, 9f);
            body.weight = 5f;
            return body;
        }

        private static BodyWing Wing(ref Random random, bool left)
        {
            var axes = new float3x3(random.NextQuaternionRotation());
            axes.c0 *= left ? -1f : 1f;
            return new BodyWing
            {
                axes = axes,
                handedness = left ? -1f : 1f,
                hinge = random.NextFloat3(-0.01f, 0.01f),
                length = 0.06f,
                mass = 1e-3f,
                gravityShare = 0.4f,
            };
        }

        private static ref SoaFloat3 Column(ref SoaFloat3x3 matrix, int column)
        {
            if (column == 0)
                return ref matrix.c0;
            if (column == 1)
                return ref matrix.c1;
            return ref matrix.c2;
        }

        private static float3x3 Any(ref Random random) =>
            new float3x3(random.NextFloat3(-1f, 1f), random.NextFloat3(-1f, 1f), random.NextFloat3(-1f, 1f));

        private static float3x3 Symmetric(ref Random random)
        {
            float3x3 any = Any(ref random);
            return any + math.transpose(any);
        }
    }
}
