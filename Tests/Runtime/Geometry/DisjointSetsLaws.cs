using System;
using Alate.Geometry;
using NUnit.Framework;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of joined sets over random joins.</summary>
    public sealed class DisjointSetsLaws
    {
        [Test]
        public void Find_IsTheLowestMemberOfTheSet_HoweverTheJoinsAreOrdered()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                int count = random.NextInt(1, 60);
                var sets = new DisjointSets(new int[count + random.NextInt(3)], count);
                int[] lowest = new int[count];
                for (int member = 0; member < count; member++)
                    lowest[member] = member;
                for (int joins = random.NextInt(2 * count); joins > 0; joins--)
                {
                    int a = random.NextInt(count), b = random.NextInt(count), low = Math.Min(lowest[a], lowest[b]),
                        high = Math.Max(lowest[a], lowest[b]);
                    sets.Join(a, b);
                    lowest = Array.ConvertAll(lowest, member => member == high ? low : member);
                }

                for (int member = 0; member < count; member++)
                    Assert.That(sets.Find(member), Is.EqualTo(lowest[member]), $"seed {seed}, member {member}");
            }
        }
    }
}
