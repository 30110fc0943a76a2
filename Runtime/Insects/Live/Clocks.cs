using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Clocks of all insects: steps that are due, and the time that a picture shows.</summary>
    internal sealed class Clocks
    {
        /// <summary>Length of a step on the clocks of the frame, seconds.</summary>
        public const float FrameStep = 1f / 60f;

        /// <summary>Most steps of one frame: a quarter of a second. The rest of a longer hitch is dropped.</summary>
        public const int MostSteps = 15;

        /// <summary>Values of the clocks that the jobs read.</summary>
        public ClockTimes times = ClockTimes.All(new ClockTime { alpha = 1f });

        private StepAccumulator m_Frame = new StepAccumulator(FrameStep, MostSteps);
        private StepAccumulator m_Unscaled = new StepAccumulator(FrameStep, MostSteps);

        /// <summary>Returns true where the fixed steps of the physics, or else the frames, advance a clock.</summary>
        public static bool Advances(bool physics, WingUpdateMode clock) =>
            clock != WingUpdateMode.Manual && (clock == WingUpdateMode.FixedUpdate) == physics;

        /// <summary>Makes one fixed step of the physics due.</summary>
        public void FixedStep(float dt, List<LiveInsect> insects)
        {
            Begin(insects);
            Step(WingUpdateMode.FixedUpdate, dt, 1);
        }

        /// <summary>Makes the steps of a frame due, and sets the time within the last step of each clock that the frame shows.</summary>
        public void Frame(float dt, float unscaledDt, List<LiveInsect> insects)
        {
            Begin(insects);
            Step(WingUpdateMode.Update, FrameStep, m_Frame.Advance(dt));
            Step(WingUpdateMode.UnscaledTime, FrameStep, m_Unscaled.Advance(unscaledDt));
            float length = Time.fixedDeltaTime;
            Show(
                WingUpdateMode.FixedUpdate, length > 0f ? (float)math.saturate((Time.timeAsDouble - Time.fixedTimeAsDouble) / length) : 1f);
            Show(WingUpdateMode.Update, m_Frame.Alpha);
            Show(WingUpdateMode.UnscaledTime, m_Unscaled.Alpha);
        }

        /// <summary>Lets the wings of all clocks be drawn in the next frame.</summary>
        public void MoveAll()
        {
            for (int clock = 0; clock < ClockTimes.Count; clock++)
                times[clock].moved = true;
        }

        /// <summary>Notes that wings have been drawn.</summary>
        public void EndDrawing()
        {
            for (int clock = 0; clock < ClockTimes.Count; clock++)
                times[clock].moved &= !times[clock].inUse;
        }

        private void Begin(List<LiveInsect> insects)
        {
            for (int clock = 0; clock < ClockTimes.Count; clock++)
            {
                times[clock].count = 0;
                times[clock].inUse = false;
            }

            foreach (LiveInsect live in insects)
                times[live.Clock].inUse |= live.Detail != WingDetail.Frozen || live.insect.Flyer != null;
        }

        private void Step(WingUpdateMode mode, float length, int count)
        {
            ref ClockTime clock = ref times[mode];
            clock.length = length;
            clock.count = count;
            clock.time += count * (double)length;
            clock.moved |= clock.IsDue;
        }

        private void Show(WingUpdateMode mode, float alpha)
        {
            ref ClockTime clock = ref times[mode];
            clock.moved |= alpha != clock.alpha;
            clock.alpha = alpha;
        }
    }
}
