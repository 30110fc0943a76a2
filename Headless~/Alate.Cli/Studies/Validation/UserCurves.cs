using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>Measured curves of a user: a CSV file for each quantity, rows of t/T and value.</summary>
internal static partial class UserCurves
{
    /// <summary>Distance between two rows, over the usual one, from which on the curve has a hole there.</summary>
    private const double k_Hole = 3;

    private const double k_LeastLikeness = 0.9, k_LeastSize = 0.7, k_MostSize = 1.3;
    private const string k_Data = "--data";

    /// <summary>Puts the curves of a folder in place of the published ones.</summary>
    /// <exception cref="UserException">No file, one of an unknown quantity, or one that is no curve.</exception>
    public static List<ValidationCurve> Read(string folder, IReadOnlyList<ValidationCurve> curves)
    {
        string[] files = Directory.GetFiles(folder, "*.csv");
        if (files.Length == 0)
            throw new UserException($"'{folder}' has no CSV file. Known: {Names(curves)}.");
        string stranger = files.FirstOrDefault(file => curves.All(curve => curve.Key != Path.GetFileNameWithoutExtension(file)));
        if (stranger != null)
            throw new UserException($"{stranger}: there is no such curve. Known: {Names(curves)}.");
        return curves.Select(curve =>
        {
            string file = files.FirstOrDefault(name => Path.GetFileNameWithoutExtension(name) == curve.Key);
            return file == null ? curve : curve with { Measured = TextFile.Read(file, reader => Curve(reader, curve)), Published = k_Data };
        }).ToList();
    }

    /// <summary>Rows of the curves of --data: correlation and size of the model's last one.</summary>
    public static IEnumerable<ValidationRow> Rows(
        IReadOnlyList<ValidationCurve> curves) => curves.Where(curve => curve.Published == k_Data).SelectMany(curve => new[]
    {
        new ValidationRow(
            "tethered dragonfly", $"{curve.Title}: correlation of {curve.Ours[^1].Name} with the curve of --data", k_LeastLikeness, 1,
            k_Data, "ours", k_Data, DragonflyCurves.Correlation(curve.Ours[^1].Values, curve.Measured), double.NaN)
        {
            Table = ValidationTable.Data,
        },
        new ValidationRow(
            "tethered dragonfly", $"{curve.Title}: most less least of {curve.Ours[^1].Name} over that of the curve of --data", k_LeastSize,
            k_MostSize, k_Data, "ours; about 57 is a sign of radians in place of degrees, about 100 of shares in place of per cent", k_Data,
            Size(curve.Ours[^1].Values) / Size(curve.Measured), double.NaN)
        {
            Table = ValidationTable.Data,
        },
    });

    // Between the rows straight, over the end of the beat too; not a number where rows are missing.
    private static double[] Curve(TextReader reader, ValidationCurve curve)
    {
        var rows = new List<(double Time, double Value)>();
        int line = 0;
        while (reader.ReadLine() is string text)
        {
            line++;
            string[] cells = text.Split(',');
            if (text.Trim().Length == 0)
                continue;
            if (line == 1 && !Number(cells[0], out _))
            {
                CheckHeading(text, cells, curve.Units);
                continue;
            }

            if (cells.Length != 2 || !Number(cells[0], out double time) || !Number(cells[1], out double value))
                throw new FormatException($"line {line}: {Quote.Of(text)} is not t/T and a value.");
            if (time < 0 || time > 1 || (rows.Count > 0 && time <= rows[^1].Time))
            {
                throw new FormatException(
                    FormattableString.Invariant($"line {line}: {time} is not after the row before it and between 0 and 1."));
            }
            if (value < curve.Range.Least || value > curve.Range.Most)
            {
                throw new FormatException(FormattableString.Invariant(
                    $"line {line}: {value} is not between {curve.Range.Least} and {curve.Range.Most} ({curve.Units[0]})."));
            }
            rows.Add((time, value));
        }

        if (rows.Count < 3)
            throw new FormatException($"it has {rows.Count} rows; a beat needs at least three.");
        if (rows.All(row => row.Value == rows[0].Value))
            throw new FormatException(FormattableString.Invariant($"all its values are {rows[0].Value}; there is nothing to compare."));
        double[] even = Even(rows, curve.Ours[0].Values.Length);
        if (2 * even.Count(double.IsFinite) < even.Length)
            throw new FormatException("its rows cover less than half of the beat.");
        return even;
    }

    private static void CheckHeading(string text, string[] cells, IReadOnlyList<string> units)
    {
        if (cells.Length != 2)
            throw new FormatException($"line 1: {Quote.Of(text)} is not a heading of two columns, t/T and value.");
        Match unit = UnitInBrackets().Match(cells[1]);
        if (unit.Success && !units.Contains(unit.Groups[1].Value.Trim()))
        {
            throw new FormatException(
                $"line 1: the unit {Quote.Of(unit.Groups[1].Value.Trim())} is not one of {string.Join(", ", units)}.");
        }
    }

    private static double[] Even(List<(double Time, double Value)> rows, int count)
    {
        (double time, double value) = rows[0];
        if (rows[^1].Time < time + 1)
            rows.Add((time + 1, value));
        rows.Insert(0, (rows[^2].Time - 1, rows[^2].Value));
        var gaps = rows.Zip(rows.Skip(1), (a, b) => b.Time - a.Time).Order().ToList();
        double hole = k_Hole * gaps[gaps.Count / 2];
        return Enumerable.Range(0, count).Select(n => At(rows, (double)n / count, hole)).ToArray();
    }

    private static double At(List<(double Time, double Value)> rows, double time, double hole)
    {
        int after = Math.Max(rows.FindIndex(row => row.Time >= time), 1);
        (double from, double a) = rows[after - 1];
        (double to, double b) = rows[after];
        if (to == time)
            return b;
        return to - from > hole ? double.NaN : a + (b - a) * (time - from) / (to - from);
    }

    private static double Size(double[] values) => values.Where(double.IsFinite).Max() - values.Where(double.IsFinite).Min();

    private static bool Number(string cell, out double value) =>
        double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    private static string Names(IReadOnlyList<ValidationCurve> curves) => string.Join(", ", curves.Select(curve => curve.Key + ".csv"));

    [GeneratedRegex(@"[(\[]([^)\]]*)[)\]]")]
    private static partial Regex UnitInBrackets();
}
