using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// Assigns wings to packs: wings of one rig with equal model options, clock and detail share packs. Packs are kept dense: a wing that
    /// leaves is replaced by the last one of its group, state and all, so only one pack of a group has empty lanes.
    /// </summary>
    internal sealed class PackTable : IDisposable
    {
        private readonly Dictionary<(WingRig, ModelOptions, PackKey), List<PackMemory>> m_Groups =
            new Dictionary<(WingRig, ModelOptions, PackKey), List<PackMemory>>();
        private readonly List<PackMemory> m_Packs = new List<PackMemory>();

        /// <summary>All packs, in no particular order.</summary>
        public IReadOnlyList<PackMemory> Packs => m_Packs;

        /// <summary>Finds a lane for a wing.</summary>
        public PackMemory Add(WingEntry entry, int wing)
        {
            (WingRig, ModelOptions, PackKey) key = (entry.rig, entry.parameters.options, entry.packKey);
            if (!m_Groups.TryGetValue(key, out List<PackMemory> group))
                m_Groups.Add(key, group = new List<PackMemory>());
            PackMemory pack = group.Count > 0 ? group[group.Count - 1] : null;
            if (pack == null || pack.Count == WingPack.Lanes)
            {
                pack = new PackMemory(
                    entry.rig.ViewAt(entry.packKey.detail >= WingDetail.CoarsePatches), entry.parameters.options, entry.packKey);
                group.Add(pack);
                m_Packs.Add(pack);
            }

            entry.pack = pack;
            entry.lane = pack.Add(wing, entry.parameters, entry.surroundings);
            return pack;
        }

        /// <summary>Takes a wing out; another may move into its lane.</summary>
        /// <returns>The wing that moved, or −1.</returns>
        public int Remove(WingEntry entry)
        {
            (WingRig, ModelOptions, PackKey) key = (entry.rig, entry.pack.view.options, entry.pack.packKey);
            List<PackMemory> group = m_Groups[key];
            PackMemory last = group[group.Count - 1];
            int lastLane = last.Count - 1;
            int moved = -1;
            if (last != entry.pack || lastLane != entry.lane)
            {
                moved = last.wings[lastLane];
                entry.pack.CopyWing(last, lastLane, entry.lane);
            }

            last.RemoveLast();
            if (last.Count == 0)
            {
                group.RemoveAt(group.Count - 1);
                m_Packs.Remove(last);
                last.Dispose();
                if (group.Count == 0)
                    m_Groups.Remove(key);
            }

            return moved;
        }

        public void Dispose()
        {
            foreach (PackMemory pack in m_Packs)
                pack.Dispose();
            m_Packs.Clear();
            m_Groups.Clear();
        }
    }
}
