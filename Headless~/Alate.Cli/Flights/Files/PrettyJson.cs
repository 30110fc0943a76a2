using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>Nodes of JSON as insect files are written.</summary>
internal static class PrettyJson
{
    /// <summary>Text of a node, with an end of line.</summary>
    public static string Write(JsonNode node) => JsonText.Write(JsonReader.Read(node.ToJsonString()));
}
