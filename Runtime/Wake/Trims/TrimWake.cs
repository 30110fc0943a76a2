using System;
using System.Collections.Generic;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Free wake by strips behind the beat of a trim, with the bob of the body in it: the air that <see cref="TrimBake"/> lets the wings
    /// meet.
    /// </summary>
    public sealed class TrimWake : ITrimWake
    {
        /// <summary>Beats until a wake has grown, and further ones that are averaged where it is another one in each beat.</summary>
        private const int k_GrownBeats = 2, k_MoreBeats = 3;

        /// <summary>
        /// Change of the air from beat to beat below which a wake repeats, and difference of a beat from the mean of some from which that
        /// is no air of any beat, both over the size of the air.
        /// </summary>
        private const float k_Repeats = 0.03f, k_MostDifference = 0.25f;

        /// <inheritdoc/>
        /// <exception cref="ArgumentException">A wing has no surface, or one that sheds no wake.</exception>
        public bool Find(FlightModel model, TrimState trim, in FlightCondition condition, WingInflow[] pairs)
        {
            var motion = new TrimMotion(model, trim, condition, pairs.Length);
            float scale = motion.Period / model.Length;
            var settings = new WakeSettings
            {
                Symmetric = true,
                Stream = -new float3(0f, condition.Climb, condition.Speed) * scale,
                Viscosity = WakeFluid.ViscosityOf(model.FluidDensity) * scale / model.Length,
            };
            using var wake = new FreeWake(settings, motion.Wings);
            WingInflow[] mean = Settled(wake, motion, settings.StepsPerBeat);
            if (mean == null)
                return false;
            for (int pair = 0; pair < pairs.Length; pair++)
                pairs[pair] = pair < mean.Length ? mean[pair] : default;
            return true;
        }

        // The last beat of a wake that repeats, else the mean of some beats; null where they have nothing in common.
        private static WingInflow[] Settled(FreeWake wake, TrimMotion motion, int steps)
        {
            WingInflow[] before = null, last = null;
            for (int beat = 0; beat <= k_GrownBeats; beat++)
            {
                before = last;
                last = Beat(wake, motion, steps);
            }

            if (Difference(before, last) < k_Repeats)
                return last;
            var beats = new List<WingInflow[]>();
            var mean = new WingInflow[last.Length];
            while (beats.Count < k_MoreBeats)
            {
                beats.Add(Beat(wake, motion, steps));
                for (int pair = 0; pair < mean.Length; pair++)
                    mean[pair] += beats[beats.Count - 1][pair] * (1f / k_MoreBeats);
            }

            return beats.TrueForAll(beat => Difference(beat, mean) < k_MostDifference) ? mean : null;
        }

        private static WingInflow[] Beat(FreeWake wake, TrimMotion motion, int steps)
        {
            var air = new WingInflow[wake.WingCount];
            for (int step = 0; step < steps; step++)
            {
                double time = wake.Time;
                wake.Step();
                for (int wing = 0; wing < air.Length; wing++)
                    air[wing] += WingInflow.Sample(time, motion.ToWing(wing, time, wake.Loads(wing).Inflow)) * (1f / steps);
            }

            return air;
        }

        // Not a number where the air is none.
        private static float Difference(WingInflow[] air, WingInflow[] from)
        {
            float change = 0f, size = 0f;
            for (int wing = 0; wing < air.Length; wing++)
            {
                change += (air[wing] + from[wing] * -1f).MeanSquare;
                size += from[wing].MeanSquare;
            }

            return math.sqrt(change / size);
        }
    }
}
