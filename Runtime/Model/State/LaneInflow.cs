using Unity.Mathematics;

namespace Alate
{
    /// <summary>Air that wakes have set moving at four wings, each in its own wing frame; lane = wing.</summary>
    /// <remarks>
    /// 136 bytes a wing, apart from the parameters: read once a substep, and only where a wing of the pack has such air.
    /// </remarks>
    internal struct LaneInflow
    {
        /// <summary>Velocity now, L/s; zero where no wing of the pack has an inflow.</summary>
        public SoaFloat3 velocity;

        /// <summary>1 where the series below act or still fade, else 0.</summary>
        public float4 acts;

        /// <summary>Series that was set.</summary>
        public InflowSeries wanted;

        /// <summary>Series as it acts, which nears the one that was set.</summary>
        public InflowSeries acting;

        /// <summary>Writes one wing's inflow.</summary>
        public void Set(int lane, in WingInflow inflow)
        {
            wanted.mean[lane] = inflow.mean;
            wanted.cosine1[lane] = inflow.cosine1;
            wanted.sine1[lane] = inflow.sine1;
            wanted.cosine2[lane] = inflow.cosine2;
            wanted.sine2[lane] = inflow.sine2;
            if (inflow.IsSet)
                acts[lane] = 1f;
        }
    }

    /// <summary>Terms of a series over the beat, L/s; see <see cref="WingInflow"/>.</summary>
    internal struct InflowSeries
    {
        public SoaFloat3 mean, cosine1, sine1, cosine2, sine2;
    }
}
