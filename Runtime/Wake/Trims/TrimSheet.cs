using System;
using System.Collections.Generic;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>Wake behind the beat of a trim, beat by beat: its air at the wings and its force.</summary>
    internal sealed class TrimSheet : IDisposable
    {
        /// <summary>Beats of which a mean is taken.</summary>
        private const int k_MeanBeats = 3;

        private readonly TrimMotion m_Motion;
        private readonly FreeWake m_Wake;
        private readonly int m_Steps;
        private readonly float m_Force;

        /// <param name="model">The insect.</param>
        /// <param name="condition">Of the trim.</param>
        /// <param name="motion">Of its wings.</param>
        /// <param name="settings">Of the wake, whose air is set here.</param>
        public TrimSheet(FlightModel model, in FlightCondition condition, TrimMotion motion, WakeSettings settings)
        {
            float scale = motion.Period / model.Length;
            m_Force = 2f * model.FluidDensity * math.pow(model.Length, 4f) / (motion.Period * motion.Period);
            settings.Symmetric = true;
            settings.Stream = -new float3(0f, condition.Climb, condition.Speed) * scale;
            settings.Viscosity = WakeFluid.ViscosityOf(model.FluidDensity) * scale / model.Length;
            m_Motion = motion;
            m_Steps = settings.StepsPerBeat;
            m_Wake = new FreeWake(settings, motion.Wings);
        }

        /// <summary>Mean force of the last beat on the wings and their mirror images, N.</summary>
        public float3 Force { get; private set; }

        /// <summary>Air of the first beat that is that of the beat before.</summary>
        /// <param name="grown">Beats before it.</param>
        /// <param name="most">Most beats before it.</param>
        /// <param name="change">Change from beat to beat below which the wake repeats, over the size of the air.</param>
        /// <returns>[wing] Wing lengths per second; null where there is none.</returns>
        public WingInflow[] Repeated(int grown, int most, float change)
        {
            WingInflow[] last = Beat();
            for (int beat = 1; beat <= most; beat++)
            {
                WingInflow[] before = last;
                last = Beat();
                if (beat >= grown && Difference(before, last) < change)
                    return last;
            }

            return null;
        }

        /// <summary>Mean air of the next beats.</summary>
        /// <param name="most">Difference of a beat from it, over the size of the air, from which it is no air of any beat.</param>
        /// <returns>[wing] Wing lengths per second; null where the beats have nothing in common.</returns>
        public WingInflow[] Mean(float most)
        {
            var beats = new List<WingInflow[]>();
            var mean = new WingInflow[m_Wake.WingCount];
            while (beats.Count < k_MeanBeats)
            {
                beats.Add(Beat());
                for (int wing = 0; wing < mean.Length; wing++)
                    mean[wing] += beats[beats.Count - 1][wing] * (1f / k_MeanBeats);
            }

            return beats.TrueForAll(beat => Difference(beat, mean) < most) ? mean : null;
        }

        public void Dispose() => m_Wake.Dispose();

        private WingInflow[] Beat()
        {
            var air = new WingInflow[m_Wake.WingCount];
            float3 force = default;
            for (int step = 0; step < m_Steps; step++)
            {
                double time = m_Wake.Time;
                m_Wake.Step();
                for (int wing = 0; wing < air.Length; wing++)
                {
                    WakeLoads loads = m_Wake.Loads(wing);
                    force += new float3(0f, loads.Force.yz);
                    air[wing] += WingInflow.Sample(time, m_Motion.ToWing(wing, time, loads.Inflow)) * (1f / m_Steps);
                }
            }

            Force = m_Force / m_Steps * force;
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
