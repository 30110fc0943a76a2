using System.Text.Json;
using Alate.Flight;

namespace Alate.Cli;

/// <summary>summary.json of a free flight: where it went, how far off, at which power, and its tumbles.</summary>
internal static class FreeSummaryJson
{
    public static void Write(FreeRecord record, FreePlan plan, Stream stream)
    {
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        FreeMoment last = record.Moments[^1];
        json.WriteStartObject();
        json.WriteString("species", record.Insect.Name);
        Number(json, "seconds", last.Time);
        Vector(json, "end_m", last.Position);
        Number(json, "velocity_error_m_s", record.VelocityError);
        Number(json, "lift_over_weight", record.LiftOverWeight);
        Number(json, "upstroke_share", record.UpstrokeShare);
        WingPower mean = record.MeanPower;
        Number(json, "power_w", mean.Air);
        Number(json, "positive_power_w", mean.Positive);
        Number(json, "negative_power_w", mean.Negative);
        Number(json, "aid_w", record.AidPower);
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
        WriteOptions(json, plan);
        RunJson.Write(json, plan.Record, plan.Insect);
        json.WriteEndObject();
        json.Flush();
        stream.WriteByte((byte)'\n');
    }

    private static void WriteOptions(Utf8JsonWriter json, FreePlan plan)
    {
        json.WriteStartObject("options");
        Number(json, "seconds", plan.Seconds);
        if (plan.Replay == null)
        {
            json.WriteString("pilot", plan.Pilot.Name);
            json.WriteStartArray("points_m");
            foreach (float3 point in plan.Points)
                Vector(json, null, point);
            json.WriteEndArray();
            json.WriteNumber("seed", plan.Seed);
            Number(json, "erratic", plan.Erratic);
            Vector(json, "gust_m_s", plan.Gust);
            Number(json, "aid", plan.Aid);
            Number(json, "step_s", plan.Step);
            json.WriteBoolean("guarded", plan.GuardsCommands);
        }

        json.WriteEndObject();
    }

    private static void Vector(Utf8JsonWriter json, string key, float3 value)
    {
        if (key != null)
            json.WritePropertyName(key);
        json.WriteStartArray();
        foreach (float coordinate in new[] { value.x, value.y, value.z })
            json.WriteNumberValue(Rounded(coordinate));
        json.WriteEndArray();
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
