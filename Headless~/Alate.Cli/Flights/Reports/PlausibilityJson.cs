using System.Text.Json;

namespace Alate.Cli;

/// <summary>An insect's numbers beside those of real ones, and the questions about units, in summary.json.</summary>
internal static class PlausibilityJson
{
    public static void Write(Utf8JsonWriter json, Plausibility plausibility)
    {
        json.WriteStartArray("plausibility");
        foreach (GroupBound bound in GroupBound.All)
            Write(json, bound, plausibility);
        json.WriteEndArray();
        json.WriteStartArray("doubts");
        foreach (string doubt in plausibility.Doubts)
            json.WriteStringValue(doubt);
        json.WriteEndArray();
    }

    private static void Write(Utf8JsonWriter json, GroupBound bound, Plausibility plausibility)
    {
        json.WriteStartObject();
        json.WriteString("key", bound.Key);
        json.WriteStartObject("wings");
        foreach (WingGroups wing in plausibility.Wings.Where(wing => !double.IsNaN(bound.Of(wing))))
            SummaryJson.Number(json, wing.Wing, bound.Of(wing));
        json.WriteEndObject();
        SummaryJson.Number(json, "least", bound.Low);
        SummaryJson.Number(json, "most", bound.High);
        json.WriteBoolean("published", bound.IsPublished);
        json.WriteString("source", bound.Source);
        json.WriteBoolean("outside", plausibility.Outside.Contains(bound));
        json.WriteEndObject();
    }
}
