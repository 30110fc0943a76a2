using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Alate
{
    /// <summary>Native memory of one trim table, shared by all bodies that fly by it.</summary>
    internal sealed unsafe class TrimTableMemory : IDisposable
    {
        private float* m_Block;

        /// <summary>Allocates a table for a grid, all zeros.</summary>
        public TrimTableMemory(float[] speeds, float[] climbs)
        {
            int count = speeds.Length + climbs.Length + speeds.Length * climbs.Length * TrimPoint.Floats + 1;
            m_Block = (float*)UnsafeUtility.MallocTracked((long)count * sizeof(float), 64, Allocator.Persistent, 0);
            UnsafeUtility.MemClear(m_Block, (long)count * sizeof(float));
            View = new TrimTableView
            {
                speeds = m_Block,
                climbs = m_Block + speeds.Length,
                points = m_Block + speeds.Length + climbs.Length,
                wake = m_Block + (count - 1),
                speedCount = speeds.Length,
                climbCount = climbs.Length,
            };
            for (int k = 0; k < speeds.Length; k++)
                View.speeds[k] = speeds[k];
            for (int k = 0; k < climbs.Length; k++)
                View.climbs[k] = climbs[k];
        }

        /// <summary>The table as bodies read it.</summary>
        public TrimTableView View { get; }

        /// <summary>Writes one point.</summary>
        public void Write(int speed, int climb, float[] point)
        {
            float* target = View.points + (speed * View.climbCount + climb) * TrimPoint.Floats;
            for (int k = 0; k < TrimPoint.Floats; k++)
                target[k] = point[k];
            for (int k = TrimPoint.Inflow; k < TrimPoint.Floats; k++)
                *View.wake = point[k] != 0f ? 1f : *View.wake;
        }

        public void Dispose()
        {
            if (m_Block != null)
                UnsafeUtility.FreeTracked(m_Block, Allocator.Persistent);
            m_Block = null;
        }
    }
}
