using System;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Cuts frames of any length into fixed steps, so that the result does not depend on the frame rate. The rest of a frame waits for the
    /// next one; <see cref="Alpha"/> is the time within the last step that the picture shows.
    /// </summary>
    /// <example><code>
    /// for (int steps = clock.Advance(Time.deltaTime); steps > 0; steps--)
    ///     world.Step(clock.StepLength);
    /// world.Skin(clock.Alpha);
    /// </code></example>
    [MovedFrom(true, null, "Alate", "StepClock")]
    public struct StepAccumulator
    {
        private double m_Left;

        /// <summary>Fixed steps of a length, at most so many a frame; time beyond them is dropped.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The length is not positive and finite, or there is no step a frame.</exception>
        public StepAccumulator(float stepLength, int maxStepsPerFrame)
        {
            if (!(stepLength > 0f) || float.IsInfinity(stepLength))
                throw new ArgumentOutOfRangeException(nameof(stepLength), stepLength, "Must be positive and finite, seconds.");
            if (maxStepsPerFrame < 1)
                throw new ArgumentOutOfRangeException(nameof(maxStepsPerFrame), maxStepsPerFrame, "Must be at least 1.");
            StepLength = stepLength;
            MaxStepsPerFrame = maxStepsPerFrame;
            m_Left = 0.0;
        }

        /// <summary>Length of a step, seconds.</summary>
        public float StepLength { get; }

        /// <summary>Most steps that one frame may ask for.</summary>
        public int MaxStepsPerFrame { get; }

        /// <summary>Time within the last step that a frame shows, 0 to 1; the picture trails the simulation by up to one step.</summary>
        public float Alpha => (float)math.saturate(m_Left / StepLength);

        /// <summary>Takes a frame's time, seconds, and ignores one that is not positive and finite.</summary>
        /// <returns>How many steps to make now.</returns>
        public int Advance(float seconds)
        {
            if (!(seconds > 0f) || float.IsInfinity(seconds))
                return 0;
            m_Left += seconds;
            int steps = (int)math.min(math.floor(m_Left / StepLength), MaxStepsPerFrame);
            m_Left = math.min(m_Left - steps * (double)StepLength, StepLength);
            return steps;
        }
    }
}
