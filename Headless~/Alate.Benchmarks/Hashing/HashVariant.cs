using System.Linq;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>A way to run a scene that must not show in its hash.</summary>
/// <param name="Workers">Threads besides the calling one; fewer where the machine has fewer processors.</param>
/// <param name="Order">Of creation: 0 as numbered, 1 backwards, above that shuffled by this seed.</param>
/// <param name="Shift">Wings of each kind, 0 to 3, that are made first and do not count: all others lie in other lanes, beside other
/// wings.</param>
internal readonly record struct HashVariant(int Workers, int Order, int Shift)
{
    /// <summary>Ways that are compared.</summary>
    public static readonly HashVariant[] All = [new(1, 0, 0), new(2, 1, 1), new(8, 2, 2), new(0, 3, 3)];

    /// <summary>Numbers from 0 in the order of creation.</summary>
    public int[] OrderOf(int count)
    {
        int[] order = Enumerable.Range(0, count).ToArray();
        if (Order == 1)
            return order.Reverse().ToArray();
        var random = Random.CreateFromIndex((uint)Order);
        for (int k = count - 1; Order > 1 && k > 0; k--)
        {
            int other = random.NextInt(k + 1);
            (order[k], order[other]) = (order[other], order[k]);
        }

        return order;
    }
}
