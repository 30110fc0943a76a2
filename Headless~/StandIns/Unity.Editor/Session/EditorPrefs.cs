using System.Collections.Generic;

namespace UnityEditor;

/// <summary>Kept until the process ends.</summary>
public sealed class EditorPrefs
{
    private static readonly Dictionary<string, object> s_Values = [];

    public static bool GetBool(string key) => GetBool(key, false);
    public static bool GetBool(string key, bool defaultValue) => Get(key, defaultValue);
    public static void SetBool(string key, bool value) => s_Values[key] = value;
    public static float GetFloat(string key) => GetFloat(key, 0f);
    public static float GetFloat(string key, float defaultValue) => Get(key, defaultValue);
    public static void SetFloat(string key, float value) => s_Values[key] = value;
    public static int GetInt(string key) => GetInt(key, 0);
    public static int GetInt(string key, int defaultValue) => Get(key, defaultValue);
    public static void SetInt(string key, int value) => s_Values[key] = value;
    public static string GetString(string key) => GetString(key, "");
    public static string GetString(string key, string defaultValue) => Get(key, defaultValue);
    public static void SetString(string key, string value) => s_Values[key] = value;
    public static bool HasKey(string key) => s_Values.ContainsKey(key);
    public static void DeleteKey(string key) => s_Values.Remove(key);

    private static T Get<T>(string key, T defaultValue) => s_Values.TryGetValue(key, out object value) && value is T t ? t : defaultValue;
}
