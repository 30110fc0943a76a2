using System.Text.Json;

namespace Alate.Cli;

/// <summary>Measures of a run, or the reason why there are none.</summary>
/// <param name="Run">Its index.</param>
/// <param name="Measures">Values in the order of the study; NaN where it has none.</param>
/// <param name="Problem">Why it could not be flown; null where it was.</param>
internal sealed record StudyRow(int Run, double[] Measures, string Problem)
{
    private const string k_Run = "run", k_Measures = "measures", k_Problem = "problem";

    /// <summary>The row as a line of a file, every number to its last bit.</summary>
    public byte[] Line()
    {
        var bytes = new System.Buffers.ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(bytes))
        {
            json.WriteStartObject();
            json.WriteNumber(k_Run, Run);
            json.WriteStartArray(k_Measures);
            foreach (double value in Measures)
            {
                if (double.IsFinite(value))
                    json.WriteNumberValue(value);
                else
                    json.WriteNullValue();
            }

            json.WriteEndArray();
            json.WriteString(k_Problem, Problem);
            json.WriteEndObject();
        }

        return [.. bytes.WrittenSpan, (byte)'\n'];
    }

    /// <summary>Reads such a line; null where it is none, such as the last one of a run that was killed.</summary>
    public static StudyRow Read(string line, int measures)
    {
        try
        {
            using var json = JsonDocument.Parse(line);
            double[] values = json.RootElement.GetProperty(k_Measures).EnumerateArray()
                .Select(value => value.ValueKind == JsonValueKind.Null ? double.NaN : value.GetDouble()).ToArray();
            return values.Length == measures
                ? new StudyRow(json.RootElement.GetProperty(k_Run).GetInt32(), values, json.RootElement.GetProperty(k_Problem).GetString())
                : null;
        }
        catch (Exception problem) when (problem is JsonException or KeyNotFoundException or InvalidOperationException or FormatException)
        {
            return null;
        }
    }
}
