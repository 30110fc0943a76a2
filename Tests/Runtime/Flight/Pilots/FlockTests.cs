using Alate.Flight;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Neighbours that the grid finds, against looking at everybody.</summary>
    public sealed class FlockTests
    {
        [Test]
        public void Grid_SeesWhatLookingAtAllSees([Values(1, 2, 60, 400)] int count, [Values(1u, 2u, 3u)] uint seed)
        {
            using var members = new NativeArray<FlockMember>(Swarm(count, seed), Allocator.TempJob);
            using var views = new NativeArray<FlockView>(count, Allocator.TempJob);
            FlockGrid.Look(members, views);
            for (int k = 0; k < count; k++)
            {
                FlockView expected = LookAtAll(members, k);
                Assert.That(views[k].count, Is.EqualTo(expected.count), $"member {k}");
                Assert.That(math.distance(views[k].apart, expected.apart), Is.LessThan(1e-4f));
                Assert.That(math.distance(views[k].centre, expected.centre), Is.LessThan(1e-3f));
                Assert.That(math.distance(views[k].velocity, expected.velocity), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void Members_ThatAreNoNumbers_HarmNobody()
        {
            FlockMember[] swarm = Swarm(50, 4);
            swarm[7].position = float.NaN;
            swarm[9].position = float.PositiveInfinity;
            swarm[11].velocity = float.NaN;
            using var members = new NativeArray<FlockMember>(swarm, Allocator.TempJob);
            using var views = new NativeArray<FlockView>(swarm.Length, Allocator.TempJob);
            FlockGrid.Look(members, views);
            for (int k = 0; k < swarm.Length; k++)
            {
                if (k != 7 && k != 9)
                    Assert.That(math.all(math.isfinite(views[k].apart + views[k].centre + views[k].velocity)), Is.True, $"member {k}");
            }
        }

        private static FlockMember[] Swarm(int count, uint seed)
        {
            var random = new Random(seed);
            var swarm = new FlockMember[count];
            for (int k = 0; k < count; k++)
            {
                swarm[k] = new FlockMember
                {
                    position = random.NextFloat3(-20f, 20f),
                    velocity = random.NextFloat3(-1f, 1f),
                    sight = random.NextFloat(2f, 9f),
                    room = 3f,
                    group = k % 2,
                };
            }

            return swarm;
        }

        private static FlockView LookAtAll(NativeArray<FlockMember> members, int index)
        {
            FlockView view = default;
            FlockMember self = members[index];
            for (int k = 0; k < members.Length; k++)
            {
                float3 way = members[k].position - self.position;
                float distance = math.length(way);
                if (k == index)
                    continue;
                if (distance < self.room)
                    view.apart -= (1f - distance / self.room) * way / distance;
                if (distance > self.sight || members[k].group != self.group)
                    continue;
                view.centre += members[k].position;
                view.velocity += members[k].velocity;
                view.count++;
            }

            view.centre /= math.max(view.count, 1);
            view.velocity /= math.max(view.count, 1);
            return view;
        }
    }
}
