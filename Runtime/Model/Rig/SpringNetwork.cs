using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>The mass-spring network of Eq. 12: along the chains, across neighbouring chains, both diagonals of each cell.</summary>
    internal static class SpringNetwork
    {
        /// <summary>Makes all springs, ordered by their first joint; none between two roots, which the wing's base holds.</summary>
        public static Spring[] Make(RestSkeleton rest)
        {
            int n = rest.chainCount, m = rest.jointsPerChain;
            var springs = new List<Spring>(4 * n * m);
            for (int i = 0; i < n; i++)
            {
                for (int j = 0; j < m; j++)
                {
                    int joint = i * m + j;
                    if (j + 1 < m)
                        Add(springs, rest, joint, joint + 1);
                    if (i + 1 == n)
                        continue;
                    if (j > 0)
                        Add(springs, rest, joint, joint + m - 1);
                    if (j > 0)
                        Add(springs, rest, joint, joint + m);
                    if (j + 1 < m)
                        Add(springs, rest, joint, joint + m + 1);
                }
            }

            return springs.ToArray();
        }

        private static void Add(List<Spring> springs, RestSkeleton rest, int a, int b) =>
            springs.Add(new Spring { a = a, b = b, length = math.distance(rest.joints[a], rest.joints[b]) });
    }
}
