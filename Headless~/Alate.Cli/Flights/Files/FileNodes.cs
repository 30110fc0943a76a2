using System.Text.Json.Nodes;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Values of files as JSON that is written.</summary>
internal static class FileNodes
{
    /// <summary>A value as a key has it: a decimal, a place in metres, a bool or a word.</summary>
    public static JsonNode Of(object value) => value switch
    {
        decimal number => JsonValue.Create(number),
        bool isSo => JsonValue.Create(isSo),
        Vector3 place => Place(place),
        _ => JsonValue.Create((string)value),
    };

    /// <summary>A number of a preset in the unit of a file.</summary>
    public static JsonNode Number(float value, decimal perUnit) => JsonValue.Create(FileNumber.ToFile(value, perUnit));

    /// <summary>A place in metres as the file has it.</summary>
    public static JsonArray Place(Vector3 metres) => new(
        Number(metres.x, FilePlace.PerMetre), Number(metres.y, FilePlace.PerMetre), Number(metres.z, FilePlace.PerMetre));
}
