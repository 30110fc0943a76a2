using Unity.Mathematics;

namespace Alate
{
    /// <summary>What one step job does: for each <see cref="ClockId"/> how many steps of what length.</summary>
    internal struct StepPlan
    {
        /// <summary>Seconds of one step.</summary>
        public float4 length;

        /// <summary>Steps; 0 lets the wings of that clock stand.</summary>
        public int4 count;

        /// <summary>One step for the wings of all clocks.</summary>
        public static StepPlan All(float dt) => new StepPlan { length = dt, count = 1 };

        /// <summary>So many steps for one clock.</summary>
        public static StepPlan For(ClockId clock, float dt, int count)
        {
            StepPlan plan = default;
            plan.Set(clock, dt, count);
            return plan;
        }

        /// <summary>Sets the steps of one clock.</summary>
        public void Set(ClockId clock, float dt, int steps)
        {
            length[(int)clock] = dt;
            count[(int)clock] = steps;
        }

        /// <summary>Whether any wing would move.</summary>
        public bool IsEmpty => !math.any((count > 0) & (length > 0f));
    }
}
