using System.Text.Json;

namespace Alate.Cli;

/// <summary>
/// inflow.json: velocity of the air that the wake sets moving at each wing, as a series over the beat, m/s in axes of the body:
/// mean + Σ cos(2πk t/T) · cosine + sin(2πk t/T) · sine.
/// </summary>
internal static class InflowJson
{
    public static void Write(WakeFlight flight, FlightInflow inflow, Stream stream)
    {
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteNumber("version", 1);
        json.WriteString("species", flight.Flight.Insect.Name);
        json.WriteNumber("frequency_hz", Math.Round(1.0 / flight.Period, 6));
        json.WriteStartArray("wings");
        foreach (RecordedWing wing in flight.Wings)
        {
            WingInflow series = inflow.Wings[(wing.Wing.Name, wing.Placement.Side)];
            json.WriteStartObject();
            json.WriteString("wing", wing.SideAndName);
            Vector(json, "mean_m_s", series.mean);
            Vector(json, "cosine_1_m_s", series.cosine1);
            Vector(json, "sine_1_m_s", series.sine1);
            Vector(json, "cosine_2_m_s", series.cosine2);
            Vector(json, "sine_2_m_s", series.sine2);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
        json.Flush();
        stream.WriteByte((byte)'\n');
    }

    private static void Vector(Utf8JsonWriter json, string name, float3 value)
    {
        json.WriteStartArray(name);
        for (int axis = 0; axis < 3; axis++)
            json.WriteNumberValue(Math.Round(value[axis], 5));
        json.WriteEndArray();
    }
}
