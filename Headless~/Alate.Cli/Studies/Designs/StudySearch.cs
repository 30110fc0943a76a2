namespace Alate.Cli;

/// <summary>A search whose points follow from the rows of those before: the same rows give the same points, so that it goes on.</summary>
internal sealed class StudySearch
{
    private readonly StudyFile m_File;
    private readonly EvolutionStrategy m_Strategy;
    private int m_Asked;
    private bool m_IsTold = true;

    public StudySearch(StudyFile file)
    {
        m_File = file;
        m_Strategy = new EvolutionStrategy(file.Parameters.Count, file.Seed);
    }

    /// <summary>Runs of so many that a user asks for: whole generations.</summary>
    public static int Runs(int count, int parameters)
    {
        int size = EvolutionStrategy.SizeOf(parameters);
        return (count + size - 1) / size * size;
    }

    /// <summary>Fills in the points that follow from the rows there are, one generation further than they go.</summary>
    /// <param name="points">[run][parameter] Values; null where they do not follow yet.</param>
    /// <param name="rows">Rows by their run.</param>
    public void Extend(double[][] points, IReadOnlyDictionary<int, StudyRow> rows)
    {
        while (TryTell(rows) && m_Asked < points.Length)
        {
            foreach (double[] shares in m_Strategy.Ask())
                points[m_Asked++] = shares.Select((share, k) => m_File.Parameters[k].At(share)).ToArray();
            m_IsTold = false;
        }
    }

    // Waits for all rows of a generation.
    private bool TryTell(IReadOnlyDictionary<int, StudyRow> rows)
    {
        if (m_IsTold)
            return true;
        var told = new List<StudyRow>();
        for (int run = m_Asked - m_Strategy.Size; run < m_Asked; run++)
        {
            if (!rows.TryGetValue(run, out StudyRow row))
                return false;
            told.Add(row);
        }

        m_Strategy.Tell(m_File.Goal.Order(told, m_File.Measures));
        return m_IsTold = true;
    }
}
