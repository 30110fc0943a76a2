using Random = Unity.Mathematics.Random;

namespace Alate.Cli;

/// <summary>Choice of the values of a study's runs.</summary>
internal static class StudyDesign
{
    public const string Grid = "grid", LatinHypercube = "latin-hypercube", Sobol = "sobol", Saltelli = "saltelli",
        Search = "search";

    /// <summary>All designs.</summary>
    public static IReadOnlyList<string> Names { get; } = [Grid, LatinHypercube, Sobol, Saltelli, Search];

    /// <summary>Number of runs.</summary>
    public static long Runs(string design, int count, IReadOnlyList<StudyParameter> parameters) => design switch
    {
        Grid => parameters.Aggregate(
            1L, (runs, parameter) => Math.Min(runs * parameter.Values.Count, long.MaxValue / StudyKeys.MostValues)),
        Saltelli => count * (parameters.Count + 2L),
        Search => StudySearch.Runs(count, parameters.Count),
        _ => count,
    };

    /// <summary>[run][parameter] Values; null of a search, whose points follow from the rows before.</summary>
    public static double[][] Points(string design, int count, uint seed, IReadOnlyList<StudyParameter> parameters) => design switch
    {
        Grid => GridOf(parameters),
        LatinHypercube => Scaled(Hypercube(count, parameters.Count, seed), parameters),
        Sobol => Scaled(SobolPoints(count, parameters.Count), parameters),
        Saltelli => Scaled(SaltelliPoints(count, parameters.Count), parameters),
        Search => new double[StudySearch.Runs(count, parameters.Count)][],
        _ => throw new ArgumentOutOfRangeException(nameof(design), design, "no design"),
    };

    /// <summary>
    /// [run][dimension] Points A of a Sobol sequence, then points B, its other half of the dimensions, then for each dimension points A
    /// with that one taken from B: Saltelli et al. 2010, Comput. Phys. Commun. 181, 259-270.
    /// </summary>
    internal static double[][] SaltelliPoints(int count, int dimensions)
    {
        double[][] both = SobolPoints(count, 2 * dimensions);
        var points = new List<double[]>();
        points.AddRange(both.Select(point => point[..dimensions]));
        points.AddRange(both.Select(point => point[dimensions..]));
        for (int k = 0; k < dimensions; k++)
        {
            foreach (double[] point in both)
            {
                double[] mixed = point[..dimensions];
                mixed[k] = point[dimensions + k];
                points.Add(mixed);
            }
        }

        return [.. points];
    }

    /// <summary>[run][dimension] In each dimension one point in each of COUNT equal parts, at random in it.</summary>
    internal static double[][] Hypercube(int count, int dimensions, uint seed)
    {
        var random = Random.CreateFromIndex(seed);
        double[][] points = Enumerable.Range(0, count).Select(_ => new double[dimensions]).ToArray();
        for (int k = 0; k < dimensions; k++)
        {
            int[] parts = Enumerable.Range(0, count).ToArray();
            for (int run = 0; run < count; run++)
            {
                int other = random.NextInt(run, count);
                (parts[run], parts[other]) = (parts[other], parts[run]);
                points[run][k] = (parts[run] + random.NextDouble()) / count;
            }
        }

        return points;
    }

    // Without the origin, at which every parameter has its least value.
    private static double[][] SobolPoints(int count, int dimensions)
    {
        var sequence = new SobolSequence(dimensions);
        sequence.Next();
        return Enumerable.Range(0, count).Select(_ => sequence.Next()).ToArray();
    }

    private static double[][] Scaled(double[][] shares, IReadOnlyList<StudyParameter> parameters) =>
        Array.ConvertAll(shares, point => point.Select((share, k) => parameters[k].At(share)).ToArray());

    // The last parameter changes fastest.
    private static double[][] GridOf(IReadOnlyList<StudyParameter> parameters)
    {
        IEnumerable<double[]> points = [[]];
        foreach (StudyParameter parameter in parameters)
            points = points.SelectMany(point => parameter.Values.Select(value => (double[])[.. point, value]));
        return points.ToArray();
    }
}
