namespace Alate.Cli;

/// <summary>All rows of a study, and what they say together.</summary>
internal sealed class StudyResult
{
    private readonly SortedDictionary<int, StudyRow> m_Rows;

    /// <summary>Takes the rows; all runs have one.</summary>
    public StudyResult(StudyPlan plan, SortedDictionary<int, StudyRow> rows)
    {
        Plan = plan;
        m_Rows = rows;
        plan.Search?.Extend(plan.Points, rows);
        Front = plan.File.Most == null ? [] : ParetoFront.Of(Values(plan.File.Most), Values(plan.File.Least));
        if (plan.File.Design == StudyDesign.Saltelli)
            Sensitivities = plan.File.Measures.Select(name => Sensitivity.Of(Values(name), plan.File.Parameters.Count)).ToList();
    }

    /// <summary>The plan that was flown.</summary>
    public StudyPlan Plan { get; }

    /// <summary>Rows in the order of the runs.</summary>
    public IEnumerable<StudyRow> Rows => m_Rows.Values;

    /// <summary>Runs of the Pareto front, by the measure that should be large, the most first.</summary>
    public IReadOnlyList<int> Front { get; }

    /// <summary>[measure][parameter] Shares of the variance; null for a design that does not give them.</summary>
    public IReadOnlyList<Sensitivity[]> Sensitivities { get; }

    /// <summary>Run that a search found, or those that no other beats; none where nothing was looked for.</summary>
    public HashSet<int> Best => Plan.File.Goal == null ? [.. Front] : [BestSoFar()[^1].Run];

    /// <summary>[run] Best row of a search among those up to it.</summary>
    public StudyRow[] BestSoFar()
    {
        StudyRow[] rows = [.. Rows];
        int[] rank = new int[rows.Length], order = Plan.File.Goal.Order(rows, Plan.File.Measures);
        for (int place = 0; place < order.Length; place++)
            rank[order[place]] = place;
        var best = new StudyRow[rows.Length];
        int first = 0;
        for (int run = 0; run < rows.Length; run++)
        {
            first = rank[run] < rank[first] ? run : first;
            best[run] = rows[first];
        }

        return best;
    }

    /// <summary>Runs that could not be flown.</summary>
    public int Problems => Rows.Count(row => row.Problem != null);

    /// <summary>[run] Values of a measure.</summary>
    public double[] Values(string measure)
    {
        int index = Plan.File.Measures.ToList().IndexOf(measure);
        return Rows.Select(row => row.Measures[index]).ToArray();
    }
}
