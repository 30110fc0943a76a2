using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Cli.Input;

namespace Alate.Cli.Validation;

/// <summary>Measured curves of a user: a CSV file for each quantity, rows of t/T and value.</summary>
internal static class UserCurves
{
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
            return file == null ? curve : curve with { Measured = TextFile.Read(file, reader => Curve(reader, curve.Ours[0].Values.Length)) };
        }).ToList();
    }

    /// <summary>Rows of the curves that are measured: correlation with the model's last one.</summary>
    public static IEnumerable<ValidationRow> Rows(IReadOnlyList<ValidationCurve> curves) => curves.Where(curve => curve.Measured != null).Select(curve => new ValidationRow(
        $"tethered dragonfly, {curve.Title}: correlation of {curve.Ours[^1].Name} with the curve of --data", 0.9, 1, "0.9 or more", "--data",
        DragonflyRows.Correlation(curve.Ours[^1].Values, curve.Measured), double.NaN, "not known"));

    // Between the rows straight, over the end of the beat too.
    private static double[] Curve(TextReader reader, int count)
    {
        var rows = new List<(double Time, double Value)>();
        int line = 0;
        while (reader.ReadLine() is string text)
        {
            line++;
            string[] cells = text.Split(',');
            if (text.Trim().Length == 0 || (line == 1 && !double.TryParse(cells[0], NumberStyles.Float, CultureInfo.InvariantCulture, out _)))
                continue;
            if (cells.Length != 2 || !Number(cells[0], out double time) || !Number(cells[1], out double value))
                throw new FormatException($"line {line}: '{text}' is not t/T and a value.");
            if (time < 0 || time > 1 || (rows.Count > 0 && time <= rows[^1].Time))
                throw new FormatException(FormattableString.Invariant($"line {line}: {time} is not after the row before it and between 0 and 1."));
            rows.Add((time, value));
        }

        if (rows.Count < 3)
            throw new FormatException($"it has {rows.Count} rows; a beat needs at least three.");
        rows.Insert(0, (rows[^1].Time - 1, rows[^1].Value));
        rows.Add((rows[1].Time + 1, rows[1].Value));
        return Enumerable.Range(0, count).Select(n => At(rows, (double)n / count)).ToArray();
    }

    private static double At(List<(double Time, double Value)> rows, double time)
    {
        int after = Math.Max(rows.FindIndex(row => row.Time >= time), 1);
        (double from, double a) = rows[after - 1];
        (double to, double b) = rows[after];
        return to > from ? a + (b - a) * (time - from) / (to - from) : b;
    }

    private static bool Number(string cell, out double value) =>
        double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    private static string Names(IReadOnlyList<ValidationCurve> curves) => string.Join(", ", curves.Select(curve => curve.Key + ".csv"));
}
