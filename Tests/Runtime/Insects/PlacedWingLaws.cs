using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Wings where they are drawn: their axes, there and back, and what the body's flight makes of the air around them.</summary>
    public sealed class PlacedWingLaws
    {
        [Test]
        public void AxesOfAPlacedWing_AreThoseThatAreDrawn(
            [Values(1u, 2u, 3u)] uint seed, [Values] bool left, [Values(1f, -1f)] float mirror)
        {
            var random = Random.CreateFromIndex(seed);
            Quaternion turn = random.NextQuaternionRotation();
            Vector3 at = random.NextFloat3(-5f, 5f), scale = new Vector3(2f * mirror, 2f, 2f);
            var matrix = Matrix4x4.TRS(at, turn, scale);
            WingFrame frame = Frame(left);
            var placed = new PlacedWing(matrix, frame);
            Assert.That(placed.isValid);
            Assert.That(placed.length, Is.EqualTo(2f * frame.length).Within(1e-5f));
            Near(placed.hinge, matrix.MultiplyPoint3x4(frame.origin));
            Near(placed.span, ((Vector3)(float3)matrix.MultiplyVector(frame.axes.c0)).normalized);
            Near(placed.up, ((Vector3)(float3)matrix.MultiplyVector(frame.axes.c1)).normalized);
            Near(placed.forward, ((Vector3)(float3)matrix.MultiplyVector(frame.axes.c2)).normalized);
            float3 some = random.NextFloat3(-1f, 1f);
            Near(placed.ToWorld(placed.ToWing(some)), some);
            Near(placed.AxisToWorld(placed.AxisToWing(some)), some);

            // A turn about an axis is the mirrored turn about the mirrored axis less its sign.
            float3 other = random.NextFloat3(-1f, 1f);
            Near(placed.ToWing(math.cross(some, other)), math.cross(placed.AxisToWing(some), placed.ToWing(other)));
            Near(placed.ToWorld(math.cross(some, other)), math.cross(placed.AxisToWorld(some), placed.ToWorld(other)));
        }

        [Test]
        public void AWingThatIsScaledUnevenly_HasAxesAtRightAngles([Values(1u, 2u, 3u, 4u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            Matrix4x4 matrix = Matrix4x4.TRS(random.NextFloat3(), random.NextQuaternionRotation(), random.NextFloat3(0.3f, 3f))
                * Matrix4x4.Rotate(random.NextQuaternionRotation());
            WingFrame frame = Frame(seed % 2 == 0);
            var placed = new PlacedWing(matrix, frame);
            Assert.That(new[]
            {
                math.dot(placed.span, placed.up), math.dot(placed.up, placed.forward), math.dot(placed.forward, placed.span),
                math.length(placed.span) - 1f, math.length(placed.up) - 1f, math.length(placed.forward) - 1f,
            }, Is.All.Zero.Within(1e-5f));
            float3 drawnSpan = matrix.MultiplyVector(frame.axes.c0), drawnForward = matrix.MultiplyVector(frame.axes.c2);
            Assert.That(placed.length, Is.EqualTo(math.length(drawnSpan) * frame.length).Within(1e-4f));
            Near(placed.span, math.normalize(drawnSpan));
            Assert.That(math.dot(placed.up, drawnForward), Is.Zero.Within(1e-5f), "up is across the drawn surface");
            Assert.That(math.dot(placed.up, (float3)matrix.MultiplyVector(frame.axes.c1)), Is.Positive);
            Assert.That(math.dot(placed.forward, drawnForward), Is.Positive);
        }

        [Test]
        public void AWingWithoutSize_IsNone_AndAFlatOneIsAWing()
        {
            WingFrame frame = Frame(false);
            Assert.That(Scaled(1f, 0f, 1f).isValid, "flat: its normal is that of what is left");
            foreach (bool left in new[] { false, true })
            {
                var flat = new PlacedWing(Matrix4x4.Scale(new Vector3(1f, 0f, 1f)), Frame(left));
                var thin = new PlacedWing(Matrix4x4.Scale(new Vector3(1f, 1e-3f, 1f)), Frame(left));
                Assert.That(math.distance(flat.up, thin.up), Is.LessThan(0.01f), "it keeps its upper side");
                Assert.That(math.distance(flat.forward, thin.forward), Is.LessThan(0.01f));
            }

            Assert.That(Scaled(0f, 1f, 1f).isValid, Is.False);
            Assert.That(Scaled(1f, 1f, 0f).isValid, Is.False);
            Assert.That(Scaled(float.NaN, 1f, 1f).isValid, Is.False);
            Assert.That(Scaled(1.1e-6f / frame.length, 1f, 1f).isValid);
            Assert.That(Scaled(0.9e-6f / frame.length, 1f, 1f).isValid, Is.False);
            Assert.That(new PlacedWing(Matrix4x4.Translate(new Vector3(0f, float.PositiveInfinity, 0f)), frame).isValid, Is.False);
        }

        // In wing lengths a second: metres are those of the size in which the wing is drawn, or of the units.
        [Test]
        public void AroundAWing_TheAirIsThatOfTheFlight([Values(0f, 0.1f)] float metresPerUnit, [Values] bool left)
        {
            const float length = 0.05f, share = 0.7f;
            WingFrame frame = Frame(left);
            var placed = new PlacedWing(Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 40f, -20f), 3f * Vector3.one), frame);
            var flight = new BodyFlight
            {
                position = new float3(0.9f, 2.1f, 2.7f),
                velocity = new float3(1f, -2f, 3f),
                angularVelocity = new float3(3f, 1f, -2f),
                wind = new float3(0.5f, 0.6f, -0.7f),
                forward = math.normalize(new float3(0f, 1f, 2f)),
                gravity = new float3(0f, -9.81f, 0f),
                metresPerUnit = metresPerUnit,
            };
            WingSurroundings around = flight.Around(placed, length, share);
            float scale = metresPerUnit > 0f ? metresPerUnit : length / (3f * frame.length);
            Near(around.wind * length, scale * placed.ToWing(flight.wind - flight.velocity));
            Near(around.hinge * length, scale * placed.ToWing(placed.hinge - flight.position));
            Near(around.gravity * length, share * placed.ToWing(flight.gravity));
            Near(around.angularVelocity, placed.AxisToWing(flight.angularVelocity));
            Assert.That(around.speed, Is.EqualTo(scale * math.sqrt(14f)).Within(1e-5f));
            Assert.That(around.angleOfAttack, Is.EqualTo(math.asin(1f / math.sqrt(5f))).Within(1e-5f));
        }

        // From the beat's mean to the angles of rest, in radians; what is no angle is level, what is beyond 90° is 90°.
        [Test]
        public void AFoldedWing_IsOnTheWayToItsRest([Values(0.25f, 1f)] float fold)
        {
            WingPreset preset = ScriptableObject.CreateInstance<WingPreset>();
            preset.Rest.flap = 60f;
            preset.Rest.sweep = -100f;
            preset.Rest.feather = 30f;
            preset.Rest.tilt = float.NaN;
            preset.Rest.feet = new Vector3(1f, 2f, 3f);
            var values = new PresetValues(preset);
            values.parameters.tilt = 0.2f;
            WingDrive drive = values.Folded(fold);
            Assert.That(values.Feet, Is.EqualTo(new Vector3(1f, 2f, 3f)));
            Assert.That(drive.frequency, Is.EqualTo(values.parameters.maxFrequency));
            Assert.That(drive.amplitude, Is.Zero);
            Assert.That(values.parameters.meanFlap, Is.Not.Zero);
            Assert.That(drive.meanFlap, Is.EqualTo(fold * (math.PI / 3f - values.parameters.meanFlap)).Within(1e-6f));
            Assert.That(drive.meanSweep, Is.EqualTo(-fold * math.PI / 2f).Within(1e-6f));
            Assert.That(drive.meanFeather, Is.EqualTo(fold * math.PI / 6f).Within(1e-6f));
            Assert.That(drive.tilt, Is.EqualTo(-fold * 0.2f).Within(1e-6f));
            Object.DestroyImmediate(preset);
        }

        private static PlacedWing Scaled(float x, float y, float z) => new PlacedWing(Matrix4x4.Scale(new Vector3(x, y, z)), Frame(false));

        private static WingFrame Frame(bool left) => new WingFrame(
            new float3(0.1f, 0.2f, -0.1f),
            new float3x3(new float3(left ? -1f : 1f, 0f, 0f), new float3(0f, 1f, 0f), new float3(0f, 0f, 1f)), 0.8f, left);

        private static void Near(float3 found, float3 expected) => Assert.That(math.distance(found, expected), Is.LessThan(2e-5f));
    }
}
