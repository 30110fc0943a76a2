using System;

namespace Alate
{
    public sealed partial class WingWorld
    {
        /// <summary>Number of times a wing fell back to its driven pose because its state was not finite, of all wings together.</summary>
        internal unsafe int CountResets()
        {
            CompleteUse();
            int count = 0;
            foreach (WingEntry entry in m_Entries)
                count += entry == null ? 0 : (int)entry.pack.view.readings->resets[entry.lane];
            return count;
        }

        /// <summary>
        /// Reads a wing's state for tools and tests, without copying it. Valid until the next call that changes the world.
        /// </summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public WingReading Read(WingHandle wing)
        {
            WingEntry entry = Entry(wing);
            return new WingReading(m_Arrays, entry);
        }

        /// <summary>
        /// Starts or stops keeping the load on every patch, for <see cref="WingReading.PatchForce"/>; all wings of the pack are kept.
        /// </summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public void RecordPatches(WingHandle wing, bool on)
        {
            WingEntry entry = Entry(wing);
            m_Arrays.Download(m_Packs.Packs, m_Entries);
            entry.pack.Record(on);
        }
    }
}
