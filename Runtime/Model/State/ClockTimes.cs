namespace Alate
{
    /// <summary>Steps that are due on one clock, and the time that its wings are drawn at.</summary>
    internal struct ClockTime
    {
        /// <summary>Seconds stepped so far.</summary>
        public double time;

        /// <summary>Seconds of one step.</summary>
        public float length;

        /// <summary>Steps that are due; 0 lets the wings of the clock stand.</summary>
        public int count;

        /// <summary>Substeps of each step of wings that carry a body, for measurements; 0 lets the wings choose.</summary>
        public int substeps;

        /// <summary>Time within the last step that is drawn, 0 its start, 1 its end.</summary>
        public float alpha;

        /// <summary>True where wings moved, or alpha did, since they were drawn.</summary>
        public bool moved;

        /// <summary>True where a wing that is not frozen keeps the clock.</summary>
        public bool inUse;

        /// <summary>True where wings have to be stepped.</summary>
        public readonly bool IsDue => inUse && count > 0 && length > 0f;

        /// <summary>True where wings have to be deformed.</summary>
        public readonly bool IsDrawn => inUse && moved;
    }

    /// <summary>[<see cref="WingUpdateMode"/>] All clocks, by value, as the jobs take them.</summary>
    internal unsafe struct ClockTimes
    {
        private ClockTime m_FixedUpdate, m_Update, m_UnscaledTime, m_Manual;

        /// <summary>Number of clocks.</summary>
        public static int Count => sizeof(ClockTimes) / sizeof(ClockTime);

        public ref ClockTime this[int clock]
        {
            get
            {
                fixed (ClockTimes* all = &this)
                    return ref ((ClockTime*)all)[clock];
            }
        }

        public ref ClockTime this[WingUpdateMode clock] => ref this[(int)clock];

        /// <summary>One time for all clocks.</summary>
        public static ClockTimes All(in ClockTime time) =>
            new ClockTimes { m_FixedUpdate = time, m_Update = time, m_UnscaledTime = time, m_Manual = time };

        /// <summary>Returns true where any wing has to be stepped.</summary>
        public bool AnyDue()
        {
            bool due = false;
            for (int clock = 0; clock < Count; clock++)
                due |= this[clock].IsDue;
            return due;
        }

        /// <summary>Returns true where any wing has to be deformed.</summary>
        public bool AnyDrawn()
        {
            bool drawn = false;
            for (int clock = 0; clock < Count; clock++)
                drawn |= this[clock].IsDrawn;
            return drawn;
        }
    }
}
