namespace Alate.Cli;

/// <summary>A part of a study: every COUNT-th run.</summary>
/// <param name="Number">From 1.</param>
/// <param name="Count">Number of parts.</param>
internal readonly record struct StudyShard(int Number, int Count)
{
    /// <summary>The whole study.</summary>
    public static StudyShard Whole { get; } = new(1, 1);

    /// <summary>Reads <c>I/N</c>.</summary>
    public static bool TryParse(string text, out StudyShard shard)
    {
        const int k_Most = 100_000;
        string[] parts = (text ?? "").Split('/');
        bool isShard = parts.Length == 2 && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            & int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int count)
            && number >= 1 && number <= count && count <= k_Most;
        shard = isShard
            ? new StudyShard(int.Parse(parts[0], CultureInfo.InvariantCulture), int.Parse(parts[1], CultureInfo.InvariantCulture))
            : default;
        return isShard;
    }

    /// <summary>Its runs of a study of so many.</summary>
    public IEnumerable<int> Runs(int runs)
    {
        for (int run = Number - 1; run < runs; run += Count)
            yield return run;
    }

    /// <summary>Its parts for workers.</summary>
    public IEnumerable<StudyShard> Split(int workers)
    {
        for (int worker = 0; worker < workers; worker++)
            yield return new StudyShard(Number + Count * worker, Count * workers);
    }

    public override string ToString() => FormattableString.Invariant($"{Number}/{Count}");
}
