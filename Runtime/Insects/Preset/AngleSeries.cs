using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>An angle over the beat as a Fourier series, degrees: mean + Σ a_k cos(k · 360° t/T + δ_k).</summary>
    [Serializable]
    public struct AngleSeries
    {
        /// <summary>Mean over the beat, degrees, −180 to 180.</summary>
        [Tooltip("Degrees of the mean over the beat, -180 to 180.")]
        public float mean;

        /// <summary>
        /// Amplitude (x) and phase (y) of the first, second, … harmonic, degrees, at most <see cref="WingKinematics.Harmonics"/> of them;
        /// null for a constant.
        /// </summary>
        [Tooltip("Amplitude and phase of each harmonic, degrees: X cos(k t/T + Y). At most eight.")]
        public Vector2[] harmonics;

        /// <summary>A series of a mean and harmonics, degrees.</summary>
        /// <param name="mean">Degrees.</param>
        /// <param name="harmonics">Amplitude and phase of each, degrees.</param>
        public AngleSeries(float mean, params Vector2[] harmonics)
        {
            this.mean = mean;
            this.harmonics = harmonics;
        }

        /// <summary>The series through a table of one beat; harmonics beyond <see cref="WingKinematics.Harmonics"/> are left out.</summary>
        /// <param name="degrees">Values at t/T = 0, 1/n, … (n − 1)/n, at least three.</param>
        /// <exception cref="ArgumentException">Fewer than three values, or one that is not finite.</exception>
        public static AngleSeries FromTable(IReadOnlyList<float> degrees)
        {
            int count = degrees?.Count ?? 0;
            if (count < 3)
                throw new ArgumentException($"A table of one beat needs at least three values; it has {count}.", nameof(degrees));
            var harmonics = new Vector2[math.min(count / 2, WingKinematics.Harmonics)];
            double sum = 0.0;
            for (int n = 0; n < count; n++)
            {
                if (!math.isfinite(degrees[n]))
                    throw new ArgumentException($"Value {n} of the table is {degrees[n]}; it must be finite.", nameof(degrees));
                sum += degrees[n];
            }

            for (int k = 1; k <= harmonics.Length; k++)
            {
                double cos = 0.0, sin = 0.0, share = (2 * k == count ? 1.0 : 2.0) / count;
                for (int n = 0; n < count; n++)
                {
                    double angle = 2.0 * Math.PI * k * n / count;
                    cos += share * degrees[n] * Elementary.Cos(angle);
                    sin += share * degrees[n] * Elementary.Sin(angle);
                }

                harmonics[k - 1] = new Vector2(
                    (float)Math.Sqrt(cos * cos + sin * sin), (float)(Elementary.Atan2(-sin, cos) * 180.0 / Math.PI));
            }

            return new AngleSeries((float)(sum / count), harmonics);
        }

        /// <summary>The angle at a time of the beat, degrees.</summary>
        /// <param name="turns">t/T.</param>
        public readonly float At(float turns)
        {
            float angle = mean;
            for (int k = 0; harmonics != null && k < harmonics.Length; k++)
                angle += harmonics[k].x * Elementary.Cos((k + 1) * 2f * math.PI * turns + math.radians(harmonics[k].y));
            return angle;
        }

        /// <summary>Writes the series in the units of the model.</summary>
        internal readonly void WriteTo(ref WingKinematics kinematics, DrivenAngle angle)
        {
            kinematics.SetMean(angle, math.radians(mean));
            for (int k = 0; harmonics != null && k < math.min(harmonics.Length, WingKinematics.Harmonics); k++)
                kinematics.SetHarmonic(angle, k + 1, math.radians(harmonics[k].x), math.radians(harmonics[k].y));
        }

        /// <summary>A copy with every number in its range.</summary>
        internal readonly AngleSeries Clamped()
        {
            var clamped = new AngleSeries(Clamped(mean), harmonics);
            if (harmonics == null)
                return clamped;
            clamped.harmonics = new Vector2[math.min(harmonics.Length, WingKinematics.Harmonics)];
            for (int k = 0; k < clamped.harmonics.Length; k++)
                clamped.harmonics[k] = new Vector2(Clamped(harmonics[k].x), math.isfinite(harmonics[k].y) ? harmonics[k].y : 0f);
            return clamped;
        }

        private static float Clamped(float degrees) => math.isfinite(degrees) ? math.clamp(degrees, -180f, 180f) : 0f;
    }
}
