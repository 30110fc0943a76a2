using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Random but valid wings in random flight, from one seed.</summary>
    internal sealed class RandomFlight
    {
        private Random m_Random;

        public RandomFlight(uint seed)
        {
            m_Random = new Random(seed);
            Parameters = RandomParameters();
            Surroundings = RandomSurroundings();
            Substeps = m_Random.NextInt(1, 60);
        }

        public WingParameters Parameters { get; }

        public WingSurroundings Surroundings { get; }

        /// <summary>Number of substeps before the check.</summary>
        public int Substeps { get; }

        public ref Random Random => ref m_Random;

        /// <summary>A monarch's rig with these parameters, flown for <see cref="Substeps"/>.</summary>
        public PackFixture Fly()
        {
            var fixture = new PackFixture(Monarch.Rig(m_Random.NextInt(16, 300)), Parameters, Surroundings);
            for (int k = 0; k < Substeps; k++)
                PackStep.Run(ref fixture.Pack, fixture.scratch, fixture.Substep);
            return fixture;
        }

        private WingParameters RandomParameters()
        {
            WingParameters p = Monarch.Parameters;
            p.maxFrequency = m_Random.NextFloat(6f, 40f);
            p.amplitude = m_Random.NextFloat3(new float3(0.3f, 0f, 0f), new float3(1.2f, 0.4f, 0.5f));
            p.phase = m_Random.NextFloat3(-2f, 2f);
            p.meanFlap = m_Random.NextFloat(-0.3f, 0.3f);
            p.tilt = m_Random.NextFloat(-0.8f, 0.8f);
            p.chordDelay = m_Random.NextFloat(0f, 0.4f);
            p.spanDelay = m_Random.NextFloat(0f, 0.3f);
            p.rootShare = m_Random.NextFloat(0.4f, 1f);
            p.elasticity = m_Random.NextFloat(0.4f, 3f);
            p.airDensity = m_Random.NextFloat(1f, 20f);
            p.options.coefficients = (CoefficientSet)m_Random.NextInt(0, 3);
            p.referenceFrequency = 1.1f * p.maxFrequency;
            return p;
        }

        private WingSurroundings RandomSurroundings() => new WingSurroundings
        {
            wind = m_Random.NextFloat3(-20f, 20f),
            gravity = m_Random.NextFloat3Direction() * m_Random.NextFloat(0f, 500f),
            speed = m_Random.NextFloat(0f, 3f),
            angleOfAttack = m_Random.NextFloat(-1f, 1f),
        };
    }
}
