namespace Alate.Cli;

/// <summary>The best compromises between two measures.</summary>
internal static class ParetoFront
{
    /// <summary>Runs that no other run beats in one measure without losing in the other; by the first measure, the most first.</summary>
    /// <param name="most">[run] The more the better.</param>
    /// <param name="least">[run] The less the better.</param>
    public static List<int> Of(IReadOnlyList<double> most, IReadOnlyList<double> least)
    {
        var front = new List<int>();
        double best = double.PositiveInfinity;
        foreach (int run in Enumerable.Range(0, most.Count).Where(run => double.IsFinite(most[run]) && double.IsFinite(least[run]))
            .OrderByDescending(run => most[run]).ThenBy(run => least[run]))
        {
            if (least[run] < best)
            {
                front.Add(run);
                best = least[run];
            }
        }

        return front;
    }
}
