namespace UnityEditor;

public class SessionState
{
    public static bool GetBool(string key, bool defaultValue) => throw Absent.Editor;
    public static void SetBool(string key, bool value) => throw Absent.Editor;
    public static float GetFloat(string key, float defaultValue) => throw Absent.Editor;
    public static void SetFloat(string key, float value) => throw Absent.Editor;
    public static int GetInt(string key, int defaultValue) => throw Absent.Editor;
    public static void SetInt(string key, int value) => throw Absent.Editor;
    public static string GetString(string key, string defaultValue) => throw Absent.Editor;
    public static void SetString(string key, string value) => throw Absent.Editor;
    public static void EraseBool(string key) => throw Absent.Editor;
}
