using System;
using System.Text.Json;

namespace UnityEngine;

/// <summary>JSON of public fields, as Unity writes and reads it: enumerations are numbers, what is not known is left out.</summary>
public static class JsonUtility
{
    private static readonly JsonSerializerOptions s_Plain = new() { IncludeFields = true };
    private static readonly JsonSerializerOptions s_Pretty = new(s_Plain) { WriteIndented = true };

    public static string ToJson(object obj) => ToJson(obj, false);

    public static string ToJson(object obj, bool prettyPrint) =>
        obj == null ? "" : JsonSerializer.Serialize(obj, obj.GetType(), prettyPrint ? s_Pretty : s_Plain);

    public static T FromJson<T>(string json)
    {
        try
        {
            return JsonSerializer.Deserialize<T>(json, s_Plain);
        }
        catch (JsonException problem)
        {
            throw new ArgumentException($"JSON parse error: {problem.Message}");
        }
    }
}
