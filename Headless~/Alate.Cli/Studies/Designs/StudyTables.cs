using System.Threading.Tasks;
using Parquet;
using Parquet.Schema;

namespace Alate.Cli;

/// <summary>Tables of a study: a row a run, as CSV and as Parquet; shares of the variance.</summary>
internal static class StudyTables
{
    private const string k_Short = "0.00";

    /// <summary>study.csv; every number to its last bit.</summary>
    public static void WriteCsv(StudyResult result, Stream stream) => CsvTable.Write(stream, Rows(result));

    /// <summary>study.parquet, the same columns.</summary>
    public static void WriteParquet(StudyResult result, Stream stream)
    {
        StudyFile file = result.Plan.File;
        HashSet<int> best = result.Best;
        var columns = new List<ParquetColumn> { ParquetColumn.Of("run", result.Rows.Select(row => row.Run)) };
        for (int k = 0; k < file.Parameters.Count; k++)
        {
            int parameter = k;
            columns.Add(ParquetColumn.Of(
                file.Parameters[k].Column, result.Rows.Select(row => result.Plan.Points[row.Run][parameter])));
        }

        columns.AddRange(file.Measures.Select(measure => ParquetColumn.Of(Column(measure), result.Values(measure))));
        if (file.LooksForBest)
            columns.Add(ParquetColumn.Of("is_best", result.Rows.Select(row => best.Contains(row.Run))));
        columns.Add(ParquetColumn.OfTexts("problem", result.Rows.Select(row => row.Problem ?? "")));

        // The library writes into memory: the stream may be one that cannot be sought.
        using var memory = new MemoryStream();
        WriteParquet(columns, memory).GetAwaiter().GetResult();
        stream.Write(memory.ToArray());
    }

    /// <summary>sensitivity.csv: a row for each measure and parameter.</summary>
    public static void WriteSensitivities(StudyResult result, Stream stream) => CsvTable.Write(stream, Sensitivities(result, "G9"));

    /// <summary>The same for people.</summary>
    public static IEnumerable<IReadOnlyList<string>> Sensitivities(StudyResult result, string format = k_Short)
    {
        yield return ["measure", "parameter", "first_order", "total"];
        for (int m = 0; m < result.Plan.File.Measures.Count; m++)
        {
            for (int k = 0; k < result.Plan.File.Parameters.Count; k++)
            {
                Sensitivity share = result.Sensitivities[m][k];
                yield return
                [
                    Column(result.Plan.File.Measures[m]), result.Plan.File.Parameters[k].Column,
                    Share(share.First, format), Share(share.Total, format),
                ];
            }
        }
    }

    private static async Task WriteParquet(List<ParquetColumn> columns, Stream stream)
    {
        var schema = new ParquetSchema(columns.ConvertAll(column => (Field)column.Field));
        await using ParquetWriter writer = await ParquetWriter.CreateAsync(schema, stream);
        using ParquetRowGroupWriter group = writer.CreateRowGroup();
        foreach (ParquetColumn column in columns)
            await column.Write(group);
    }

    private static IEnumerable<IReadOnlyList<string>> Rows(StudyResult result)
    {
        StudyFile file = result.Plan.File;
        HashSet<int> front = result.Best;
        string[] best = file.LooksForBest ? ["is_best"] : [];
        yield return
            ["run", .. file.Parameters.Select(parameter => parameter.Column), .. file.Measures.Select(Column), .. best, "problem"];
        foreach (StudyRow row in result.Rows)
        {
            string[] isBest = file.LooksForBest ? [front.Contains(row.Run) ? "yes" : "no"] : [];
            yield return
            [
                row.Run.ToString(CultureInfo.InvariantCulture), .. result.Plan.Points[row.Run].Select(Number),
                .. row.Measures.Select(Number), .. isBest, row.Problem ?? "",
            ];
        }
    }

    // No minus before nothing.
    private static string Share(double share, string format) =>
        (format == k_Short ? Math.Round(share, 2) + 0.0 : share).ToString(format, CultureInfo.InvariantCulture);

    private static string Column(string measure) => measure.Replace(' ', '_');

    private static string Number(double value) =>
        double.IsFinite(value) ? value.ToString("R", CultureInfo.InvariantCulture) : "";
}
