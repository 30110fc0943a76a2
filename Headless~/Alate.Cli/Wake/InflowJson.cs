using System.Text.Json;

namespace Alate.Cli;

/// <summary>
/// inflow.json: velocity of the air that the wake sets moving at each wing, as a series over the beat, m/s in axes of the body:
/// mean + Σ cos(2πk t/T) · cosine + sin(2πk t/T) · sine.
/// </summary>
internal static class InflowJson
{
    /// <summary>Harmonics that are kept: with the mean, 15 numbers a wing.</summary>
    public const int Harmonics = 2;

    public static void Write(WakeFlight flight, IReadOnlyList<WakeMoment> beat, Stream stream)
    {
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteNumber("version", 1);
        json.WriteString("species", flight.Flight.Insect.Name);
        json.WriteNumber("frequency_hz", Math.Round(1.0 / flight.Period, 6));
        json.WriteStartArray("wings");
        for (int k = 0; k < flight.Wings.Count; k++)
        {
            json.WriteStartObject();
            json.WriteString("wing", WakeTable.NameOf(flight.Wings[k]));
            Vector(json, "mean_m_s", Part(beat, k, 0, Math.Cos) / 2f);
            for (int harmonic = 1; harmonic <= Harmonics; harmonic++)
            {
                Vector(json, $"cosine_{harmonic}_m_s", Part(beat, k, harmonic, Math.Cos));
                Vector(json, $"sine_{harmonic}_m_s", Part(beat, k, harmonic, Math.Sin));
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
        json.Flush();
        stream.WriteByte((byte)'\n');
    }

    /// <summary>Part of a wing's inflow that goes with a wave: twice the mean of their product.</summary>
    internal static float3 Part(IReadOnlyList<WakeMoment> beat, int wing, int harmonic, Func<double, double> wave)
    {
        float3 sum = default;
        foreach (WakeMoment at in beat)
            sum += (float)(2.0 * wave(2.0 * Math.PI * harmonic * at.Turns) / beat.Count) * at.Wings[wing].Inflow;
        return sum;
    }

    private static void Vector(Utf8JsonWriter json, string name, float3 value)
    {
        json.WriteStartArray(name);
        for (int axis = 0; axis < 3; axis++)
            json.WriteNumberValue(Math.Round(value[axis], 5));
        json.WriteEndArray();
    }
}
