using System.Security.Cryptography;
using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>Plan of a study: an insect, a flight, parameters and measures.</summary>
internal sealed class StudyPlan
{
    private readonly string m_InsectText;
    private readonly JsonPlace m_Insect;
    private readonly KeptFiles m_Files = new(InputFiles.Instance);

    /// <summary>Completes what a file says.</summary>
    /// <param name="file">What it says.</param>
    /// <param name="flight">The flight of its options.</param>
    /// <exception cref="UserException">A parameter or a measure does not exist, or an end of a parameter is out of range.</exception>
    public StudyPlan(StudyFile file, StudyFlight flight)
    {
        File = file;
        Flight = flight;
        m_InsectText = InsectFileText.Write(flight.Insect);
        m_Insect = JsonPlace.Read(new StringReader(m_InsectText));
        if (file.Measures.FirstOrDefault(name => flight.TitleOf(name) == null) is { } unknown)
        {
            throw new UserException(
                $"{file.Path}: there is no measure {Quote.Of(unknown)}. Known: {flight.KnownMeasures}.");
        }

        string missing = new[] { file.Most, file.Least }.Concat(file.Goal?.Measures ?? [])
            .FirstOrDefault(name => name != null && !file.Measures.Contains(name));
        if (missing != null)
        {
            throw new UserException(
                $"{file.Path}: {(file.Goal == null ? StudyKeys.Best : StudyKeys.Goal)}: '{missing}' is none of the study's measures.");
        }

        long runs = StudyDesign.Runs(file.Design, file.Count, file.Parameters);
        if (runs > StudyKeys.MostRuns)
            throw new UserException($"{file.Path}: the design has {runs} runs; at most {StudyKeys.MostRuns} are allowed.");
        foreach (StudyParameter parameter in file.Parameters)
            Try(parameter);
        Points = StudyDesign.Points(file.Design, file.Count, file.Seed, file.Parameters);
        Search = file.Goal == null ? null : new StudySearch(file);

        // Reads all that a flight reads: a change of it makes another study.
        flight.Check();
        Hash = HashOf();
    }

    /// <summary>The study file.</summary>
    public StudyFile File { get; }

    /// <summary>The flight of every run, without the parameters.</summary>
    public StudyFlight Flight { get; }

    /// <summary>[run][parameter] Values; null where those of a search do not follow from rows yet.</summary>
    public double[][] Points { get; }

    /// <summary>Search that the points come from; null of another design.</summary>
    public StudySearch Search { get; }

    /// <summary>SHA-256 of all that decides the results: version, file, insect, flight and the files that were read.</summary>
    public string Hash { get; }

    /// <summary>Flies a run.</summary>
    /// <param name="run">0 for the first.</param>
    public StudyRow Fly(int run)
    {
        try
        {
            return new StudyRow(run, At(Points[run]).Fly(File.Measures), null);
        }
        catch (UserException problem)
        {
            return new StudyRow(run, File.Measures.Select(_ => double.NaN).ToArray(), problem.Message);
        }
    }

    // Each end by itself, so that a range is refused before anything is flown.
    private void Try(StudyParameter parameter)
    {
        foreach (double value in parameter.Values)
        {
            try
            {
                StudyFlight flight = At([(parameter, value)]);

                // Numbers of an insect may make its trims another one's.
                if (parameter.IsOfInsect && File.IsFree)
                    flight.Check();
            }
            catch (UserException problem)
            {
                throw new UserException(FormattableString.Invariant($"{File.Path}: '{parameter.Key}' at {value}: {problem.Message}"));
            }
        }
    }

    private StudyFlight At(double[] point) => At(File.Parameters.Select((parameter, k) => (parameter, point[k])).ToArray());

    private StudyFlight At((StudyParameter Parameter, double Value)[] changes)
    {
        StudyFlight flight = Flight;
        if (Array.Exists(changes, change => change.Parameter.IsOfInsect))
            flight = flight.Of(InsectAt(changes));
        foreach ((StudyParameter parameter, double value) in changes)
            flight = parameter.IsOfInsect ? flight : flight.With(parameter.Key, value);
        return flight;
    }

    private InsectDefinition InsectAt((StudyParameter Parameter, double Value)[] changes)
    {
        string variant = KnownSpecies.Word(Flight.Variant);
        JsonPlace insect = m_Insect;
        foreach ((StudyParameter parameter, double value) in changes)
            insect = parameter.IsOfInsect ? parameter.In(insect, variant, value) : insect;
        try
        {
            return InsectFile.Read(insect, Flight.Insect.FilePath ?? File.Path, m_Files);
        }
        catch (FormatException problem)
        {
            // The lines are those of a text that nobody sees.
            throw new UserException(Regex.Replace(problem.Message, "^line [0-9]+, ", ""));
        }
    }

    private string HashOf()
    {
        var all = new StringBuilder();
        all.Append(PackageRoot.Version).Append('\n').Append(File.Text).Append('\n').Append(m_InsectText).Append('\n');
        foreach (string path in ReadFiles.Paths.Where(path => path != File.Path))
            all.Append(ReadFiles.HashOf(path)).Append('\n');
        return Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(all.ToString())));
    }
}
