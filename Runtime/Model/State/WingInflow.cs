using System;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Velocity of the air that the wake has set moving at a wing, even over the wing, as a series of the beat: mean + Σ cos kΦ · cosine_k
    /// + sin kΦ · sine_k, wing lengths per second in the frame of a right wing (X hinge to tip, Y up, Z forward). It is added to the wind
    /// that the wing meets. The default value is air that no wake has moved.
    /// </summary>
    /// <remarks>A left wing is simulated as a right wing: negate x of all five vectors.</remarks>
    [Serializable]
    public struct WingInflow : IEquatable<WingInflow>
    {
        /// <summary>Largest speed along an axis, wing lengths per second: more than 100 m/s of the shortest wing.</summary>
        internal const float Most = 3e5f;

        /// <summary>Mean over the beat, L/s, each axis up to 3·10⁵.</summary>
        public float3 mean;

        /// <summary>Parts that go with the cosine and the sine of the phase, L/s, each axis up to 3·10⁵.</summary>
        public float3 cosine1, sine1;

        /// <summary>Parts that go with the cosine and the sine of twice the phase, L/s, each axis up to 3·10⁵.</summary>
        public float3 cosine2, sine2;

        /// <summary>True where a part is not zero.</summary>
        public readonly bool IsSet => !Equals(default);

        /// <summary>Mean of the squared speed over the beat, (L/s)².</summary>
        internal readonly float MeanSquare => math.lengthsq(mean)
            + 0.5f * (math.lengthsq(cosine1) + math.lengthsq(sine1) + math.lengthsq(cosine2) + math.lengthsq(sine2));

        /// <summary>Part of a series that one of many velocities at even times makes: their mean is the series through them.</summary>
        /// <param name="beats">Time of the velocity, beats.</param>
        /// <param name="velocity">L/s.</param>
        internal static WingInflow Sample(double beats, float3 velocity)
        {
            Elementary.SinCos((float)(2.0 * Math.PI * (beats - Math.Floor(beats))), out float sin, out float cos);
            return new WingInflow
            {
                mean = velocity,
                cosine1 = 2f * cos * velocity,
                sine1 = 2f * sin * velocity,
                cosine2 = 2f * (1f - 2f * sin * sin) * velocity,
                sine2 = 4f * sin * cos * velocity,
            };
        }

        /// <summary>Multiplies all parts.</summary>
        public static WingInflow operator *(WingInflow inflow, float factor) => new WingInflow
        {
            mean = inflow.mean * factor,
            cosine1 = inflow.cosine1 * factor,
            sine1 = inflow.sine1 * factor,
            cosine2 = inflow.cosine2 * factor,
            sine2 = inflow.sine2 * factor,
        };

        /// <summary>Adds part by part.</summary>
        public static WingInflow operator +(WingInflow a, WingInflow b) => new WingInflow
        {
            mean = a.mean + b.mean,
            cosine1 = a.cosine1 + b.cosine1,
            sine1 = a.sine1 + b.sine1,
            cosine2 = a.cosine2 + b.cosine2,
            sine2 = a.sine2 + b.sine2,
        };

        /// <summary>Velocity at a phase, L/s.</summary>
        /// <param name="phase">Phase Φ of the beat, radians.</param>
        public readonly float3 At(float phase)
        {
            Elementary.SinCos(phase, out float sin, out float cos);
            return mean + cos * cosine1 + sin * sine1 + (1f - 2f * sin * sin) * cosine2 + 2f * sin * cos * sine2;
        }

        /// <inheritdoc/>
        public readonly bool Equals(WingInflow other) => mean.Equals(other.mean) && cosine1.Equals(other.cosine1)
            && sine1.Equals(other.sine1) && cosine2.Equals(other.cosine2) && sine2.Equals(other.sine2);

        /// <inheritdoc/>
        public override readonly bool Equals(object other) => other is WingInflow inflow && Equals(inflow);

        /// <inheritdoc/>
        public override readonly int GetHashCode() => HashCode.Combine(mean, cosine1, sine1, cosine2, sine2);

        /// <summary>Describes the first part that is too fast or no number; null where there is none.</summary>
        internal readonly string FindProblem() => Problem(nameof(mean), mean) ?? Problem(nameof(cosine1), cosine1)
            ?? Problem(nameof(sine1), sine1) ?? Problem(nameof(cosine2), cosine2) ?? Problem(nameof(sine2), sine2);

        private static string Problem(string name, float3 part) => math.all(math.abs(part) <= Most)
            ? null
            : FormattableString.Invariant(
                $"inflow.{name} is ({part.x}, {part.y}, {part.z}) wing lengths per second; each must be between {-Most} and {Most}.");
    }
}
