using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Inflow replayed at a wing: what a free wake has found over a beat, as mean and two harmonics. A beat from rest, a wake is there by
    /// 92 %: the series that acts nears the one that was set by e within 0.4 beats.
    /// </summary>
    internal static unsafe class WakeInflow
    {
        private const float k_BeatsPerRamp = 0.4f;

        /// <summary>Square of the speed below which an inflow that was taken away has gone, (L/s)².</summary>
        private const float k_Gone = 1e-8f;

        /// <summary>
        /// Advances the series by a substep and evaluates them at the phase of its end; call after <see cref="BeatClock"/>.
        /// </summary>
        public static void Advance(in WingPack pack, float4 dt)
        {
            ref LaneInflow inflow = ref *pack.inflow;
            if (!math.any(inflow.acts > 0f))
                return;
            float4 share = 1f - SoaMath.Exp(-dt * pack.beat->frequency * (1f / k_BeatsPerRamp));
            float4 left = default;
            Near(ref inflow.acting.mean, inflow.wanted.mean, share, ref left);
            Near(ref inflow.acting.cosine1, inflow.wanted.cosine1, share, ref left);
            Near(ref inflow.acting.sine1, inflow.wanted.sine1, share, ref left);
            Near(ref inflow.acting.cosine2, inflow.wanted.cosine2, share, ref left);
            Near(ref inflow.acting.sine2, inflow.wanted.sine2, share, ref left);
            SoaMath.SinCos(pack.beat->phase, out float4 sin, out float4 cos);
            float4 sin2 = 2f * sin * cos, cos2 = 1f - 2f * sin * sin;
            SoaFloat3 velocity = inflow.acting.mean + inflow.acting.cosine1 * cos + inflow.acting.sine1 * sin
                + inflow.acting.cosine2 * cos2 + inflow.acting.sine2 * sin2;

            // One that was set to nothing ends once nothing is left of it.
            inflow.acts = math.select(inflow.acts, 0f, left < k_Gone);
            inflow.velocity = SoaFloat3.Select(default, velocity, inflow.acts > 0f);
        }

        /// <summary>Lets the chosen wings begin in air that is at rest.</summary>
        public static void Reset(in WingPack pack, bool4 lanes)
        {
            ref LaneInflow inflow = ref *pack.inflow;
            Clear(ref inflow.velocity, lanes);
            Clear(ref inflow.acting.mean, lanes);
            Clear(ref inflow.acting.cosine1, lanes);
            Clear(ref inflow.acting.sine1, lanes);
            Clear(ref inflow.acting.cosine2, lanes);
            Clear(ref inflow.acting.sine2, lanes);
        }

        private static void Near(ref SoaFloat3 acting, in SoaFloat3 wanted, float4 share, ref float4 left)
        {
            acting += (wanted - acting) * share;
            left += SoaFloat3.LengthSquared(acting) + SoaFloat3.LengthSquared(wanted);
        }

        private static void Clear(ref SoaFloat3 vector, bool4 lanes) => vector = SoaFloat3.Select(vector, default, lanes);
    }
}
