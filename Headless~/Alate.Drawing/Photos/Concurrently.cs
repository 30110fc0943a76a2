using System.Runtime.ExceptionServices;
using System.Threading.Tasks;

namespace Alate.Drawing;

/// <summary>Pictures on all cores at once, as many as the memory of what is being painted allows.</summary>
internal static class Concurrently
{
    /// <summary>Of all that is being painted at once, bytes.</summary>
    private const long k_Memory = 1L << 29;

    /// <summary>Makes one thing of each item; the results are in the order of the items.</summary>
    /// <param name="items">The items.</param>
    /// <param name="bytes">Memory that one takes while it is being made.</param>
    /// <param name="make">Called on any thread.</param>
    /// <param name="done">Told how many are made, one call after the other; null for nobody.</param>
    public static TResult[] Map<TItem, TResult>(
        IReadOnlyList<TItem> items, long bytes, Func<TItem, TResult> make, Action<int> done = null)
    {
        var made = new TResult[items.Count];
        int count = 0;
        object gate = new();
        var limit = new ParallelOptions { MaxDegreeOfParallelism = Degree(bytes, Environment.ProcessorCount) };
        try
        {
            Parallel.For(0, made.Length, limit, k =>
            {
                made[k] = make(items[k]);
                lock (gate)
                    done?.Invoke(++count);
            });
        }
        catch (AggregateException several)
        {
            ExceptionDispatchInfo.Throw(several.InnerExceptions[0]);
        }

        return made;
    }

    /// <summary>Number of things that are made at once.</summary>
    internal static int Degree(long bytes, int cores) => (int)Math.Clamp(k_Memory / Math.Max(bytes, 1), 1, cores);
}
