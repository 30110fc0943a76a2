using System;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Prescribed motion of a wing at its root: flap, sweep, feather and tilt as Fourier series of the beat, in place of the waves of Eq. 1
    /// and the frequency of Eq. 6. A series is mean + Σ (c_k cos kΦ + s_k sin kΦ), radians. The default value prescribes nothing.
    /// </summary>
    public unsafe struct WingKinematics : IEquatable<WingKinematics>
    {
        /// <summary>Number of harmonics of each series.</summary>
        public const int Harmonics = 8;

        /// <summary>Number of series: flap, sweep, feather, tilt.</summary>
        internal const int Angles = 4;

        /// <summary>Numbers of one series: its mean, then cosine and sine of each harmonic.</summary>
        internal const int Stride = 1 + 2 * Harmonics;

        /// <summary>Numbers of all series.</summary>
        internal const int Count = Angles * Stride;

        /// <summary>Frequency of the beat, hertz, 0.1 to 1000; 0 prescribes nothing.</summary>
        public float frequency;

        /// <summary>
        /// True where the delays of chains and joints (Eq. 2) act on the prescribed angles; false where the whole wing is driven at once.
        /// </summary>
        public bool waves;

        private Terms m_Series;

        /// <summary>True where a motion is prescribed.</summary>
        public readonly bool IsSet => frequency != 0f;

        /// <summary>Mean of a series, radians.</summary>
        /// <param name="angle">The series.</param>
        public readonly float Mean(DrivenAngle angle) => At((int)angle * Stride);

        /// <summary>Cosine and sine of a harmonic, radians.</summary>
        /// <param name="angle">The series.</param>
        /// <param name="harmonic">1 to <see cref="Harmonics"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such harmonic.</exception>
        public readonly float2 Harmonic(DrivenAngle angle, int harmonic)
        {
            int k = Index(angle, harmonic);
            return new float2(At(k), At(k + 1));
        }

        /// <summary>Sets the mean of a series, radians.</summary>
        /// <param name="angle">The series.</param>
        /// <param name="mean">Radians.</param>
        public void SetMean(DrivenAngle angle, float mean) => Set((int)angle * Stride, mean);

        /// <summary>Sets a harmonic, amplitude · cos(harmonic · Φ + phase).</summary>
        /// <param name="angle">The series.</param>
        /// <param name="harmonic">1 to <see cref="Harmonics"/>.</param>
        /// <param name="amplitude">Radians.</param>
        /// <param name="phase">Radians.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such harmonic.</exception>
        public void SetHarmonic(DrivenAngle angle, int harmonic, float amplitude, float phase)
        {
            int k = Index(angle, harmonic);
            Set(k, amplitude * Elementary.Cos(phase));
            Set(k + 1, -amplitude * Elementary.Sin(phase));
        }

        /// <summary>Describes the first number that is out of its range; null where there is none.</summary>
        public readonly string FindProblem()
        {
            if (!IsSet)
                return null;
            if (!(frequency >= WingBounds.MaxFrequency.Min && frequency <= WingBounds.MaxFrequency.Max))
            {
                return "kinematics.frequency is "
                    + FormattableString.Invariant(
                        $"{frequency} hertz; it must be between {WingBounds.MaxFrequency.Min} and {WingBounds.MaxFrequency.Max}.");
            }
            for (int k = 0; k < Count; k++)
            {
                if (!(math.abs(At(k)) <= math.PI))
                {
                    return FormattableString.Invariant(
                        $"kinematics.{(DrivenAngle)(k / Stride)} has a term of {At(k)} radians; it must be between -π and π.");
                }
            }

            return null;
        }

        /// <inheritdoc/>
        public readonly bool Equals(WingKinematics other)
        {
            bool same = frequency == other.frequency && waves == other.waves;
            for (int k = 0; k < Count && same; k++)
                same = At(k) == other.At(k);
            return same;
        }

        /// <inheritdoc/>
        public override readonly bool Equals(object other) => other is WingKinematics kinematics && Equals(kinematics);

        /// <inheritdoc/>
        public override readonly int GetHashCode() => HashCode.Combine(frequency, waves, At(1), At(2));

        /// <summary>A number of the series, in the order of the lanes.</summary>
        internal readonly float At(int index) => m_Series.values[index];

        private void Set(int index, float value) => m_Series.values[index] = value;

        private static int Index(DrivenAngle angle, int harmonic)
        {
            if (harmonic < 1 || harmonic > Harmonics)
                throw new ArgumentOutOfRangeException(nameof(harmonic), harmonic, $"Must be 1 to {Harmonics}.");
            return (int)angle * Stride + 2 * harmonic - 1;
        }

        // [angle · Stride + term]
        private struct Terms
        {
            public fixed float values[Count];
        }
    }
}
