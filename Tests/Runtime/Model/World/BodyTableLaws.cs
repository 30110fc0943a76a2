using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Laws of the table of bodies: random wings and bodies, joined to groups that share no pack.</summary>
    public sealed unsafe class BodyTableLaws
    {
        private readonly List<PackMemory> m_Packs = new List<PackMemory>();
        private readonly List<WingEntry> m_Wings = new List<WingEntry>();
        private WingRig m_Rig;

        [SetUp]
        public void SetUp() => m_Rig = TestWings.Rig(8);

        [TearDown]
        public void TearDown()
        {
            m_Wings.ForEach(wing => wing.Dispose());
            m_Packs.ForEach(pack => pack.Dispose());
            m_Wings.Clear();
            m_Packs.Clear();
            m_Rig.Release();
        }

        [Test]
        public void Groups_HoldEachPackAndBodyOnce_AndWhatABodyTies([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            var random = new Random(seed);
            MakeWings(random.NextInt(1, 12), ref random);
            using (var table = new BodyTable())
            {
                var bodies = new List<BodyHandle>();
                var free = new List<WingEntry>(m_Wings);
                for (int k = 0; k < 7; k++)
                {
                    BodyHandle body = table.Add(new FlyingBody { aid = 10f + k, wingCount = 77 });
                    bodies.Add(body);
                    for (int wings = random.NextInt(0, 4); wings > 0 && free.Count > 0; wings--)
                    {
                        int at = random.NextInt(free.Count);
                        table.Attach(body, free[at], new BodyWing { length = 0.1f + at, pack = -5, lane = -5 });
                        free.RemoveAt(at);
                    }
                }

                table.Remove(bodies[2]);
                bodies.RemoveAt(2);
                table.Layout(m_Packs);
                Check(table, bodies);

                // A second layout, of fewer packs tied together, remembers nothing of the first.
                foreach (WingEntry wing in m_Wings.Where(wing => wing.body != 0).Take(2))
                    table.Detach(wing);
                table.Layout(m_Packs);
                Check(table, bodies);
            }
        }

        [Test]
        public void ABody_KeepsItsNumbers_HoweverManyFollow_AndItsPlaceIsUsedAgainUnderANewName()
        {
            using (var table = new BodyTable())
            {
                var bodies = Enumerable.Range(0, 40)
                    .Select(k => table.Add(new FlyingBody { aid = k, mode = BodyMode.Held })).ToList();
                for (int k = 0; k < 40; k++)
                {
                    FlyingBody body = table[bodies[k]];
                    Assert.That((body.aid, body.used, body.mode), Is.EqualTo(((float)k, 1, BodyMode.Held)));
                }

                Assert.That((table.Count, table.Contains(bodies[7]), table.Contains(default)), Is.EqualTo((40, true, false)));
                table.Remove(bodies[7]);
                Assert.That((table.Count, table.Contains(bodies[7]), table[bodies[7]].used), Is.EqualTo((39, false, 0)));
                BodyHandle next = table.Add(new FlyingBody { aid = 100f });
                Assert.That((next.index, next.version == bodies[7].version, next.IsNone), Is.EqualTo((bodies[7].index, false, false)));
                Assert.That((table.Count, table.Contains(next), table.Contains(bodies[7])), Is.EqualTo((40, true, false)));
                Assert.That(table.Contains(new BodyHandle(40, 3)), Is.False);
                Assert.That((table[next].aid, table[bodies[8]].aid), Is.EqualTo((100f, 8f)));
            }
        }

        [Test]
        public void RemovingABody_FreesItsWings_AndDetachingAWingTwiceIsNothing()
        {
            var random = new Random(9u);
            MakeWings(4, ref random);
            using (var table = new BodyTable())
            {
                BodyHandle one = table.Add(default), other = table.Add(default);
                table.Attach(one, m_Wings[0], default);
                table.Attach(one, m_Wings[1], default);
                table.Attach(other, m_Wings[2], default);
                Assert.That(m_Wings.Select(wing => wing.body), Is.EqualTo(new[] { one.index + 1, one.index + 1, other.index + 1, 0 }));
                Assert.That(table.FirstWing(one), Is.SameAs(m_Wings[0]));
                table.Detach(m_Wings[0]);
                table.Detach(m_Wings[0]);
                table.Detach(m_Wings[3]);
                Assert.That(table.FirstWing(one), Is.SameAs(m_Wings[1]));
                table.Remove(one);
                Assert.That(m_Wings.Select(wing => wing.body), Is.EqualTo(new[] { 0, 0, other.index + 1, 0 }));
            }
        }

        // Unity refuses a job an array that was not made.
        [Test]
        public void WithoutWingsAndPacks_TheListsAreThere_AndATableMayBeDisposedTwice()
        {
            var table = new BodyTable();
            table.Add(default);
            table.Layout(m_Packs);
            Assert.That((table.GroupCount, table.Groups.IsCreated), Is.EqualTo((0, true)));
            GroupLists lists = table.Lists(null);
            Assert.That(lists.wings != null && lists.packList != null && lists.bodies != null, Is.True);
            table.Dispose();
            Assert.That(() => table.Dispose(), Throws.Nothing);
        }

        private void Check(BodyTable table, List<BodyHandle> bodies)
        {
            GroupLists lists = table.Lists(null);
            var groupOf = new Dictionary<int, int>();
            var carried = new List<int>();
            int first = -1;
            for (int k = 0; k < table.GroupCount; k++)
            {
                PackGroup group = table.Groups[k];
                int[] packs = Enumerable.Range(group.firstPack, group.packCount).Select(at => lists.packList[at]).ToArray();
                Assert.That(packs, Is.Not.Empty.And.Ordered);
                Assert.That(packs[0], Is.GreaterThan(first), "in the order of their first packs");
                first = packs[0];
                foreach (int pack in packs)
                    groupOf.Add(pack, k);
                for (int at = group.firstBody; at < group.firstBody + group.bodyCount; at++)
                {
                    int body = lists.bodyList[at];
                    carried.Add(body);
                    foreach (WingEntry wing in m_Wings.Where(wing => wing.body == body + 1))
                        Assert.That(packs, Has.Member(wing.pack.index), "a body with the packs of its wings");
                }
            }

            Assert.That(groupOf.Keys, Is.EquivalentTo(Enumerable.Range(0, m_Packs.Count)), "each pack once");
            Assert.That(carried,
                Is.EquivalentTo(bodies.Select(body => body.index).Where(body => m_Wings.Exists(wing => wing.body == body + 1))));

            // Packs are together only where a chain of bodies ties them.
            for (bool changed = true; changed;)
            {
                changed = false;
                foreach (int body in carried)
                {
                    int[] tied = m_Wings.Where(wing => wing.body == body + 1).Select(wing => wing.pack.index).ToArray();
                    int least = tied.Min(pack => m_Ties[pack]);
                    foreach (int pack in tied.Where(pack => m_Ties[pack] != least))
                    {
                        m_Ties[pack] = least;
                        changed = true;
                    }
                }
            }

            for (int a = 0; a < m_Packs.Count; a++)
            {
                for (int b = 0; b < a; b++)
                    Assert.That(groupOf[a] == groupOf[b], Is.EqualTo(m_Ties[a] == m_Ties[b]), $"packs {a} and {b}");
                m_Ties[a] = a;
            }

            var places = new HashSet<int>();
            foreach (BodyHandle body in bodies)
            {
                var wings = m_Wings.Where(wing => wing.body == body.index + 1).ToList();
                Assert.That(table[body].wingCount, Is.EqualTo(wings.Count));
                for (int at = table[body].firstWing; at < table[body].firstWing + wings.Count; at++)
                {
                    BodyWing place = lists.wings[at];
                    Assert.That(places.Add(at), Is.True);
                    WingEntry wing = wings.Single(entry => entry.pack.index == place.pack && entry.lane == place.lane);
                    Assert.That((place.firstCopy, place.endCopy), Is.EqualTo((wing.lane == 0 ? wing.pack.Count : 4, 4)),
                        "the first wing of a pack stands in for those that are not there");
                    Assert.That(place.length, Is.GreaterThan(0f), "with what it was attached by");
                }
            }
        }

        private int[] m_Ties;

        // Packs of one to four wings each.
        private void MakeWings(int packs, ref Random random)
        {
            WingParameters parameters = WingParameters.Default;
            for (int k = 0; k < packs; k++)
            {
                var pack = new PackMemory(m_Rig.View, parameters.options) { index = k };
                m_Packs.Add(pack);
                for (int wings = packs == 4 ? 1 : random.NextInt(1, 5); wings > 0; wings--)
                {
                    var wing = new WingEntry(m_Rig, 1, parameters, VertexPacking.None, false) { pack = pack };
                    wing.lane = pack.Add(m_Wings.Count, parameters, default);
                    m_Wings.Add(wing);
                }
            }

            m_Ties = Enumerable.Range(0, packs).ToArray();
        }
    }
}
