using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Shorthand for values of four wings and for the tolerance of check values.</summary>
    internal static class Lanes
    {
        /// <summary>Relative tolerance of check values.</summary>
        public const double CheckTolerance = 1e-5;

        /// <summary>Vector with equal components in all four wings.</summary>
        public static SoaFloat3 All(float x, float y, float z) => new SoaFloat3(new float3(x, y, z));

        /// <summary>A wing of a species' parameters as the kernels see it, in all four lanes.</summary>
        public static LaneParameters Parameters(in WingParameters parameters)
        {
            LaneParameters lanes = default;
            for (int lane = 0; lane < 4; lane++)
                lanes.Set(lane, parameters);
            return lanes;
        }
    }
}
