using System.Text.Json;
using Alate.Flight;

namespace Alate.Cli;

/// <summary>summary.json of a free flight: where it went, how far off, at which power, and its tumbles.</summary>
internal static class FreeSummaryJson
{
    public static void Write(FreeRecord record, Stream stream)
    {
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        FreeMoment last = record.Moments[^1];
        json.WriteStartObject();
        json.WriteString("species", record.Insect.Name);
        Number(json, "seconds", last.Time);
        json.WriteStartArray("end_m");
        foreach (float coordinate in new[] { last.Position.x, last.Position.y, last.Position.z })
            json.WriteNumberValue(Rounded(coordinate));
        json.WriteEndArray();
        Number(json, "velocity_error_m_s", record.VelocityError);
        Number(json, "lift_over_weight", record.Moments.Average(at => at.Force.y) / record.Weight);
        Number(json, "upstroke_share", record.UpstrokeShare);
        Number(json, "power_w", record.Moments.Average(at => at.Power));
        Number(json, "aid_w", record.Moments.Average(at => at.AidPower));
        json.WriteStartArray("tumbles");
        foreach (FlightTumble tumble in record.Tumbles)
        {
            json.WriteStartObject();
            Number(json, "time_s", tumble.time);
            Number(json, "seconds", tumble.seconds);
            Number(json, "distance_m", tumble.distance);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
        json.Flush();
        stream.WriteByte((byte)'\n');
    }

    private static void Number(Utf8JsonWriter json, string key, double value)
    {
        if (double.IsFinite(value))
            json.WriteNumber(key, Rounded(value));
        else
            json.WriteNull(key);
    }

    private static double Rounded(double value) => System.Math.Round(value, 9);
}
