using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Finds neighbours: members sorted by cells of a grid in one job, each looking into 27 cells in another.</summary>
    internal static class FlockGrid
    {
        private const int k_MembersPerJob = 16;

        /// <summary>Views of all members. Waits for the jobs.</summary>
        /// <param name="members">[member]</param>
        /// <param name="views">[member] Filled.</param>
        public static void Look(NativeArray<FlockMember> members, NativeArray<FlockView> views)
        {
            int count = members.Length, buckets = 16;
            while (buckets < 2 * count)
                buckets *= 2;
            var starts = new NativeArray<int>(buckets + 1, Allocator.TempJob);
            var order = new NativeArray<int>(count, Allocator.TempJob, NativeArrayOptions.UninitializedMemory);
            float cell = 0f;
            foreach (FlockMember member in members)
                cell = math.max(cell, math.max(member.sight, member.room));
            cell = math.max(cell, 1e-3f);
            JobHandle sorted = new SortJob { members = members, cell = cell, starts = starts, order = order }.Schedule();
            new LookJob { members = members, cell = cell, starts = starts, order = order, views = views }
                .ScheduleParallel(count, k_MembersPerJob, sorted).Complete();
            starts.Dispose();
            order.Dispose();
        }

        private static int3 CellOf(float3 position, float cell) => (int3)math.floor(math.clamp(position / cell, -1e6f, 1e6f));

        // Teschner et al. 2003, by primes.
        private static int Bucket(int3 at, int buckets) => ((at.x * 73856093) ^ (at.y * 19349663) ^ (at.z * 83492791)) & (buckets - 1);

        [BurstCompile]
        private struct SortJob : IJob
        {
            [ReadOnly]
            public NativeArray<FlockMember> members;

            public float cell;

            /// <summary>[bucket] First place in the order.</summary>
            public NativeArray<int> starts;

            /// <summary>[place] Members, bucket by bucket.</summary>
            public NativeArray<int> order;

            public void Execute()
            {
                int buckets = starts.Length - 1;
                for (int k = 0; k < members.Length; k++)
                    starts[Bucket(CellOf(members[k].position, cell), buckets) + 1]++;
                for (int bucket = 0; bucket < buckets; bucket++)
                    starts[bucket + 1] += starts[bucket];

                // Filled from behind, so that each start ends where it began.
                for (int k = members.Length - 1; k >= 0; k--)
                {
                    int bucket = Bucket(CellOf(members[k].position, cell), buckets);
                    order[--starts[bucket + 1]] = k;
                }

                for (int bucket = 0; bucket < buckets; bucket++)
                    starts[bucket] = starts[bucket + 1];
                starts[buckets] = members.Length;
            }
        }

        [BurstCompile]
        private struct LookJob : IJobFor
        {
            [ReadOnly]
            public NativeArray<FlockMember> members;

            public float cell;

            [ReadOnly]
            public NativeArray<int> starts;

            [ReadOnly]
            public NativeArray<int> order;

            [WriteOnly]
            public NativeArray<FlockView> views;

            public void Execute(int index)
            {
                FlockMember self = members[index];
                int3 home = CellOf(self.position, cell);
                int buckets = starts.Length - 1;
                FlockView view = default;
                for (int k = 0; k < 27; k++)
                {
                    int3 at = home + new int3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                    int bucket = Bucket(at, buckets);
                    for (int place = starts[bucket]; place < starts[bucket + 1]; place++)
                    {
                        int other = order[place];
                        if (other != index && math.all(CellOf(members[other].position, cell) == at))
                            See(self, members[other], ref view);
                    }
                }

                if (view.count > 0)
                {
                    view.centre = self.position + view.centre / view.count;
                    view.velocity /= view.count;
                }

                views[index] = view;
            }

            private static void See(in FlockMember self, in FlockMember other, ref FlockView view)
            {
                float3 way = other.position - self.position;
                float distance = math.length(way);
                if (distance < self.room)
                    view.apart -= (1f - distance / self.room) * math.normalizesafe(way, new float3(0f, 1f, 0f));
                if (!(distance <= self.sight) || other.group != self.group || !OuterBounds.Hold(other.velocity, float.MaxValue))
                    return;
                view.centre += way;
                view.velocity += other.velocity;
                view.count++;
            }
        }
    }
}
