using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The area that the air acts on is that of the wing as it is, not as it was at rest.</summary>
    public sealed unsafe class DeformedAreaTests
    {
        [TestCase(1f, 1f)]
        [TestCase(1.1f, 1f)]
        [TestCase(1f, 0.8f)]
        [TestCase(1.05f, 1.2f)]
        public void AWingThatIsStretchedEvenly_HasPatchesThatAreLargerByTheProduct(float alongSpan, float alongChord)
        {
            using (var fixture = new PackFixture(TestWings.Bake(TestWings.Lattice(), TestWings.Rectangle(), 64), RigidPlate.Parameters))
            {
                float[] rest = Areas(fixture);
                for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                {
                    fixture.Pack.pose[joint].position = new SoaFloat3(
                        fixture.rig.RestJoints[joint] * new float3(alongSpan, 1f, alongChord));
                }
                float[] stretched = Areas(fixture);

                float sum = 0f;
                for (int patch = 0; patch < rest.Length; patch++)
                {
                    sum += rest[patch];
                    Assert.That(
                        stretched[patch], Is.EqualTo(alongSpan * alongChord * rest[patch]).Within(1e-4f * rest[patch]), $"patch {patch}");
                }

                Assert.That(sum, Is.EqualTo(fixture.rig.Area).Within(1e-4f * fixture.rig.Area), "at rest");
            }
        }

        [Test]
        public void TheForceOnALargerWing_IsLargerByItsArea()
        {
            using (var fixture = new PackFixture(TestWings.Bake(TestWings.Lattice(), TestWings.Rectangle(), 64), RigidPlate.Parameters))
            {
                fixture.Pack.surroundings->wind = Lanes.All(0f, -3f, -20f);
                StrongestWind.Derive(fixture.Pack);
                float3 rest = Force(fixture);
                for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                    fixture.Pack.pose[joint].position = new SoaFloat3(fixture.rig.RestJoints[joint] * new float3(1.1f, 1f, 1.2f));

                Assert.That(math.length(rest), Is.GreaterThan(1f));
                Assert.That(math.distance(Force(fixture), 1.32f * rest), Is.LessThan(1e-4f * math.length(rest)));
            }
        }

        private static float[] Areas(PackFixture fixture)
        {
            Force(fixture);
            float[] areas = new float[fixture.rig.PatchCount];
            for (int patch = 0; patch < areas.Length; patch++)
                areas[patch] = fixture.scratch.halfDensityAreas[patch].x / (0.5f * fixture.Pack.parameters->numbers.airDensity.x);
            return areas;
        }

        private static float3 Force(PackFixture fixture)
        {
            DelayedWaves.Evaluate(fixture.Pack, fixture.scratch);
            DrivenPose.Evaluate(fixture.Pack, fixture.scratch);
            CarriedSurface.Evaluate(fixture.Pack, fixture.scratch, 1e-3f);
            for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                fixture.scratch.forces[joint] = default;
            Aerodynamics.Apply(fixture.Pack, fixture.scratch);
            float3 sum = float3.zero;
            for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                sum += fixture.scratch.forces[joint][0];
            return sum;
        }
    }
}
