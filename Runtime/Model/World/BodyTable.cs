using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The flying bodies of a world in native memory, the wings that carry each, and the groups of packs that they tie together.
    /// </summary>
    internal sealed unsafe class BodyTable : IDisposable
    {
        private readonly List<BodyEntry> m_Entries = new List<BodyEntry>();
        private readonly Stack<int> m_Free = new Stack<int>();
        private int m_NextVersion = 1, m_Capacity;
        private FlyingBody* m_Bodies;
        private NativeArray<BodyWing> m_Wings;
        private NativeArray<PackGroup> m_Groups;
        private NativeArray<int> m_Lists;
        private int[] m_Parents = Array.Empty<int>(), m_GroupOf = Array.Empty<int>();
        private int m_PackCount;

        /// <summary>Bodies in use.</summary>
        public int Count => m_Entries.Count - m_Free.Count;

        /// <summary>Groups of the last layout.</summary>
        public int GroupCount { get; private set; }

        /// <summary>Adds a body without wings.</summary>
        public BodyHandle Add(in FlyingBody body)
        {
            int index = m_Free.Count > 0 ? m_Free.Pop() : m_Entries.Count;
            if (index == m_Entries.Count)
                m_Entries.Add(null);
            Reserve(m_Entries.Count);
            m_Entries[index] = new BodyEntry { version = m_NextVersion++ };
            m_Bodies[index] = body;
            m_Bodies[index].used = 1;
            m_Bodies[index].wingCount = 0;
            return new BodyHandle(index, m_Entries[index].version);
        }

        /// <summary>Attaches a wing that carries a body.</summary>
        public void Attach(BodyHandle body, WingEntry wing, in BodyWing place)
        {
            m_Entries[body.index].wings.Add(wing);
            m_Entries[body.index].places.Add(place);
            wing.body = body.index + 1;
        }

        /// <summary>The wing whose beat a body's feedback goes by.</summary>
        public WingEntry FirstWing(BodyHandle body) => m_Entries[body.index].wings[0];

        /// <summary>Lets the wings of a body meet the air of a trim's wake.</summary>
        public unsafe void MeetWake(BodyHandle body, float* point)
        {
            BodyEntry entry = m_Entries[body.index];
            for (int k = 0; k < entry.wings.Count; k++)
                entry.wings[k].Meet(BodyWake.At(point, entry.places[k].pair));
        }

        /// <summary>Takes a body out; its wings carry nothing.</summary>
        public void Remove(BodyHandle body)
        {
            foreach (WingEntry wing in m_Entries[body.index].wings)
                wing.LeaveBody();
            m_Entries[body.index] = null;
            m_Bodies[body.index] = default;
            m_Free.Push(body.index);
        }

        /// <summary>Takes a wing off the body that it carries.</summary>
        public void Detach(WingEntry wing)
        {
            if (wing.body == 0)
                return;
            BodyEntry entry = m_Entries[wing.body - 1];
            int at = entry.wings.IndexOf(wing);
            entry.wings.RemoveAt(at);
            entry.places.RemoveAt(at);
            wing.LeaveBody();
        }

        /// <summary>Returns true where there is such a body.</summary>
        public bool Contains(BodyHandle body) =>
            !body.IsNone && body.index < m_Entries.Count && m_Entries[body.index]?.version == body.version;

        /// <summary>A body; valid until the next one is added.</summary>
        public ref FlyingBody this[BodyHandle body] => ref m_Bodies[body.index];

        /// <summary>Joins packs and bodies to groups, after wings came, went or moved.</summary>
        public void Layout(IReadOnlyList<PackMemory> packs)
        {
            m_PackCount = packs.Count;
            int wings = 0;
            foreach (BodyEntry entry in m_Entries)
                wings += entry?.wings.Count ?? 0;
            GrowingArray.Reserve(ref m_Wings, math.max(wings, 1));
            GrowingArray.Reserve(ref m_Groups, math.max(packs.Count, 1));
            GrowingArray.Reserve(ref m_Lists, math.max(packs.Count + m_Entries.Count, 1));
            if (m_Parents.Length < packs.Count)
            {
                m_Parents = new int[2 * packs.Count];
                m_GroupOf = new int[2 * packs.Count];
            }

            var sets = new DisjointSets(m_Parents, packs.Count);
            int next = 0;
            for (int body = 0; body < m_Entries.Count; body++)
                PlaceWings(body, sets, ref next);
            PlaceGroups(packs, sets);
        }

        /// <summary>Lists for the job.</summary>
        public GroupLists Lists(WingPack* packs) => new GroupLists
        {
            packs = packs,
            bodies = m_Bodies,
            wings = (BodyWing*)m_Wings.GetUnsafePtr(),
            packList = (int*)m_Lists.GetUnsafePtr(),
            bodyList = (int*)m_Lists.GetUnsafePtr() + m_PackCount,
        };

        /// <summary>Groups for the job.</summary>
        public NativeArray<PackGroup> Groups => m_Groups;

        public void Dispose()
        {
            if (m_Bodies != null)
                UnsafeUtility.FreeTracked(m_Bodies, Allocator.Persistent);
            m_Bodies = null;
            GrowingArray.Free(ref m_Wings);
            GrowingArray.Free(ref m_Groups);
            GrowingArray.Free(ref m_Lists);
        }

        private void PlaceWings(int body, DisjointSets sets, ref int next)
        {
            BodyEntry entry = m_Entries[body];
            if (entry == null)
                return;
            m_Bodies[body].firstWing = next;
            m_Bodies[body].wingCount = entry.wings.Count;
            for (int k = 0; k < entry.wings.Count; k++)
            {
                WingEntry wing = entry.wings[k];
                BodyWing place = entry.places[k];
                place.pack = wing.pack.index;
                place.lane = wing.lane;
                place.firstCopy = wing.lane == 0 ? wing.pack.Count : WingPack.Lanes;
                place.endCopy = WingPack.Lanes;
                m_Wings[next++] = place;
                sets.Join(entry.wings[0].pack.index, wing.pack.index);
            }
        }

        // Groups in the order of their first pack, so that the order of packs is the order of work: counted, then filled, each pack and
        // body once.
        private void PlaceGroups(IReadOnlyList<PackMemory> packs, DisjointSets sets)
        {
            GroupCount = 0;
            for (int pack = 0; pack < packs.Count; pack++)
            {
                int root = sets.Find(pack);
                if (root == pack)
                    m_GroupOf[pack] = GroupCount++;
                m_GroupOf[pack] = m_GroupOf[root];
            }

            var groups = (PackGroup*)m_Groups.GetUnsafePtr();
            UnsafeUtility.MemClear(groups, (long)GroupCount * sizeof(PackGroup));
            for (int pack = 0; pack < packs.Count; pack++)
                groups[m_GroupOf[pack]].packCount++;
            for (int body = 0; body < m_Entries.Count; body++)
            {
                if (Carried(body))
                    groups[GroupOf(body)].bodyCount++;
            }

            int nextPack = 0, nextBody = 0;
            for (int k = 0; k < GroupCount; k++)
            {
                groups[k].firstPack = nextPack;
                groups[k].firstBody = nextBody;
                nextPack += groups[k].packCount;
                nextBody += groups[k].bodyCount;
                groups[k].packCount = groups[k].bodyCount = 0;
            }

            for (int pack = 0; pack < packs.Count; pack++)
            {
                ref PackGroup group = ref groups[m_GroupOf[pack]];
                m_Lists[group.firstPack + group.packCount++] = pack;
            }

            for (int body = 0; body < m_Entries.Count; body++)
            {
                if (!Carried(body))
                    continue;
                ref PackGroup group = ref groups[GroupOf(body)];
                m_Lists[packs.Count + group.firstBody + group.bodyCount++] = body;
            }
        }

        private bool Carried(int body) => m_Entries[body] != null && m_Entries[body].wings.Count > 0;

        private int GroupOf(int body) => m_GroupOf[m_Entries[body].wings[0].pack.index];

        private void Reserve(int count)
        {
            if (count <= m_Capacity)
                return;
            int grown = math.max(count, math.max(2 * m_Capacity, 8));
            var bodies = (FlyingBody*)UnsafeUtility.MallocTracked((long)grown * sizeof(FlyingBody), 64, Allocator.Persistent, 0);
            UnsafeUtility.MemClear(bodies, (long)grown * sizeof(FlyingBody));
            if (m_Bodies != null)
            {
                UnsafeUtility.MemCpy(bodies, m_Bodies, (long)m_Capacity * sizeof(FlyingBody));
                UnsafeUtility.FreeTracked(m_Bodies, Allocator.Persistent);
            }

            m_Bodies = bodies;
            m_Capacity = grown;
        }

        private sealed class BodyEntry
        {
            public readonly List<WingEntry> wings = new List<WingEntry>();
            public readonly List<BodyWing> places = new List<BodyWing>();
            public int version;
        }
    }
}
