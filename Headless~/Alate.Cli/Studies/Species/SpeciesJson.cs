using System.Text.Encodings.Web;
using System.Text.Json;

namespace Alate.Cli;

/// <summary>Species as JSON: units are those of the inspector, and stand in a list of their own.</summary>
internal static class SpeciesJson
{
    public static void Write(IReadOnlyList<SpeciesNumbers> sheets, Stream stream)
    {
        var options = new JsonWriterOptions { Indented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
        using var json = new Utf8JsonWriter(stream, options);
        json.WriteStartObject();
        json.WriteStartObject("units");
        foreach (FlownParameter parameter in WingNumbers.Parameters)
            json.WriteString(Key(parameter.Name), parameter.Unit);
        json.WriteEndObject();
        json.WriteStartArray("species");
        foreach (SpeciesNumbers sheet in sheets)
            Write(json, sheet);
        json.WriteEndArray();
        json.WriteEndObject();
        json.Flush();
        stream.WriteByte((byte)'\n');
    }

    private static void Write(Utf8JsonWriter json, SpeciesNumbers sheet)
    {
        json.WriteStartObject();
        json.WriteString("name", sheet.Definition.Name);
        json.WriteString("display_name", sheet.Definition.DisplayName);
        json.WriteNumber("triangles", sheet.Definition.TriangleCount);
        json.WriteStartArray("wings");
        foreach (WingNumbers wing in sheet.Wings)
            Write(json, wing);
        json.WriteEndArray();
        json.WriteStartArray("sources");
        foreach (InsectSource source in sheet.Definition.Sources)
        {
            json.WriteStartObject();
            json.WriteString("quantity", source.Quantity);
            json.WriteString("variant", source.Variant.ToString().ToLowerInvariant());
            json.WriteString("value", source.Value);
            json.WriteString("source", source.Source);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, WingNumbers wing)
    {
        json.WriteStartObject();
        json.WriteString("name", wing.Wing.Name);
        json.WriteNumber("triangles", wing.Wing.TriangleCount);
        json.WriteNumber("chains", wing.Wing.Chains);
        json.WriteNumber("joints_per_chain", wing.Wing.JointsPerChain);
        json.WriteStartObject("variants");
        for (int variant = 0; variant < wing.Variants.Count; variant++)
        {
            json.WriteStartObject(wing.Variants[variant].ToString().ToLowerInvariant());
            for (int k = 0; k < WingNumbers.Parameters.Count; k++)
                json.WriteNumber(Key(WingNumbers.Parameters[k].Name), wing.Values[variant][k]);
            json.WriteEndObject();
        }

        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static string Key(string name) => name.Replace('-', '_');
}
