using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>The clocks that run by themselves: how many steps are due, and what time a picture shows.</summary>
    internal sealed class Clocks
    {
        /// <summary>Length of a step on the clocks of the frame, seconds.</summary>
        public const float FrameStep = 1f / 60f;

        /// <summary>Most steps of one frame: a quarter of a second. The rest of a longer hitch is dropped.</summary>
        public const int MostSteps = 15;

        private StepAccumulator m_Frame = new StepAccumulator(FrameStep, MostSteps);
        private StepAccumulator m_Unscaled = new StepAccumulator(FrameStep, MostSteps);
        private readonly double[] m_Time = new double[4];

        /// <summary>Seconds that a clock has stepped.</summary>
        public double TimeOf(ClockId clock) => m_Time[(int)clock];

        /// <summary>One fixed step of the physics.</summary>
        public StepPlan FixedStep(float dt)
        {
            m_Time[(int)ClockId.Fixed] += dt;
            return StepPlan.For(ClockId.Fixed, dt, 1);
        }

        /// <summary>The steps of this frame on its two clocks.</summary>
        public StepPlan Frame(float dt, float unscaledDt)
        {
            StepPlan plan = default;
            Set(ref plan, ClockId.Frame, m_Frame.Advance(dt));
            Set(ref plan, ClockId.Unscaled, m_Unscaled.Advance(unscaledDt));
            return plan;
        }

        /// <summary>What time within the last step of each clock the picture of this frame shows.</summary>
        public float4 Alpha()
        {
            float length = Time.fixedDeltaTime;
            float fixedAlpha = length > 0f ? (float)math.saturate((Time.timeAsDouble - Time.fixedTimeAsDouble) / length) : 1f;
            return new float4(fixedAlpha, m_Frame.Alpha, m_Unscaled.Alpha, 1f);
        }

        private void Set(ref StepPlan plan, ClockId clock, int steps)
        {
            plan.Set(clock, FrameStep, steps);
            m_Time[(int)clock] += steps * (double)FrameStep;
        }
    }
}
