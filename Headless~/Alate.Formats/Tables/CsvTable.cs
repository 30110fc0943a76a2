using System.Globalization;

namespace Alate.Formats;

/// <summary>Writes rows with commas between their cells; a cell with a comma or a quote in it is quoted.</summary>
internal static class CsvTable
{
    public static void Write(Stream stream, IEnumerable<IReadOnlyList<string>> rows)
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
        foreach (IReadOnlyList<string> row in rows)
            text.WriteLine(string.Join(',', row.Select(Cell)));
    }

    /// <summary>A number in seven digits, of any size.</summary>
    public static string Number(double value) => value.ToString("0.######E+0", CultureInfo.InvariantCulture);

    private static string Cell(string text) => text.AsSpan().IndexOfAny(",\"\n") < 0 ? text : $"\"{text.Replace("\"", "\"\"")}\"";
}
