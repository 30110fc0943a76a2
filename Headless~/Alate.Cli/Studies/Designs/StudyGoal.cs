namespace Alate.Cli;

/// <summary>Aim of a search: the most or the least of a measure, where others keep to their bounds.</summary>
/// <param name="Measure">Its name.</param>
/// <param name="IsMost">The more the better; otherwise the less.</param>
/// <param name="Bounds">Measures that must lie in ranges.</param>
internal sealed record StudyGoal(string Measure, bool IsMost, IReadOnlyList<StudyBound> Bounds)
{
    /// <summary>Names of all measures that it looks at.</summary>
    public IEnumerable<string> Measures => Bounds.Select(bound => bound.Measure).Prepend(Measure);

    /// <summary>Indices of rows, the best first: those that miss their bounds by less, then those with the better measure.</summary>
    /// <param name="rows">Of runs.</param>
    /// <param name="names">Names of their measures.</param>
    public int[] Order(IReadOnlyList<StudyRow> rows, IReadOnlyList<string> names)
    {
        int measure = Index(names, Measure);
        int[] bounds = Bounds.Select(bound => Index(names, bound.Measure)).ToArray();
        return Enumerable.Range(0, rows.Count)
            .OrderBy(k => Missed(rows[k], bounds))
            .ThenBy(k => IsMost ? -rows[k].Measures[measure] : rows[k].Measures[measure])
            .ThenBy(k => rows[k].Run).ToArray();
    }

    /// <summary>True where a row keeps to all bounds.</summary>
    public bool Holds(StudyRow row, IReadOnlyList<string> names) =>
        Missed(row, Bounds.Select(bound => Index(names, bound.Measure)).ToArray()) == 0;

    private double Missed(StudyRow row, int[] bounds)
    {
        if (row.Measures.Any(double.IsNaN))
            return double.PositiveInfinity;
        double missed = 0;
        for (int k = 0; k < bounds.Length; k++)
            missed += Bounds[k].MissedBy(row.Measures[bounds[k]]);
        return missed;
    }

    private static int Index(IReadOnlyList<string> names, string name)
    {
        for (int k = 0; k < names.Count; k++)
        {
            if (names[k] == name)
                return k;
        }

        throw new ArgumentException($"There is no measure {name}.", nameof(name));
    }
}
