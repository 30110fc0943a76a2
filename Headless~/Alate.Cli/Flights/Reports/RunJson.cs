using System.Text.Json;

namespace Alate.Cli;

/// <summary>The run in summary.json, from which 'fly --from' flies it again.</summary>
internal static class RunJson
{
    /// <summary>Writes version, command, files and the insect.</summary>
    /// <param name="json">In the object of the summary.</param>
    /// <param name="record">The run; null for none, where only version and insect are written.</param>
    /// <param name="insect">Who flew.</param>
    public static void Write(Utf8JsonWriter json, RunRecord record, InsectDefinition insect)
    {
        json.WriteString(FlownRun.VersionKey, PackageRoot.Version);
        if (record != null)
        {
            json.WriteStartArray(FlownRun.CommandKey);
            foreach (string word in record.Command)
                json.WriteStringValue(word);
            json.WriteEndArray();
            json.WriteStartArray(FlownRun.InputsKey);
            foreach (InputHash input in record.Hashed())
            {
                json.WriteStartObject();
                json.WriteString(FlownRun.FileKey, input.File);
                json.WriteString(FlownRun.HashKey, input.Sha256);
                json.WriteEndObject();
            }

            json.WriteEndArray();
        }

        if (insect.FilePath != null)
            json.WriteString(FlownRun.InsectFileKey, insect.FilePath);
        json.WritePropertyName(FlownRun.InsectKey);
        json.WriteRawValue(InsectFileText.Write(insect).TrimEnd().Replace("\n", "\n  "));
    }
}
