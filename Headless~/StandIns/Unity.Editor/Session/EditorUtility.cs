using System;
using System.Collections.Generic;
using StandIns;
using Unity.StandIns;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class EditorUtility
{
    private static readonly HashSet<Object> s_Dirty = [];

    public static void SetDirty(Object target)
    {
        ArgumentNullException.ThrowIfNull(target);
        s_Dirty.Add(target);
    }

    public static bool DisplayDialog(string title, string message, string ok) => AnsweredDialogs.Tell($"{title}: {message} [{ok}]");
    public static bool DisplayDialog(string title, string message, string ok, string cancel) => throw Absent.Editor;
    public static void DisplayProgressBar(string title, string info, float progress) => ShownProgress.Show(info, progress);
    public static bool DisplayCancelableProgressBar(string title, string info, float progress) => ShownProgress.Show(info, progress);
    public static void ClearProgressBar() => ShownProgress.Clear();
    public static string SaveFilePanel(string title, string directory, string defaultName, string extension) =>
        AnsweredDialogs.Ask($"{title}: {directory}/{defaultName}.{extension}");
    public static string SaveFilePanelInProject(string title, string defaultName, string extension, string message) =>
        AnsweredDialogs.Ask($"{title}: {defaultName}.{extension}: {message}");
    public static string SaveFilePanelInProject(
        string title,
        string defaultName,
        string extension,
        string message,
        string path) => throw Absent.Editor;
    public static string OpenFilePanel(string title, string directory, string extension) =>
        AnsweredDialogs.Ask($"{title}: {directory}/*.{extension}");
    public static string OpenFolderPanel(string title, string folder, string defaultName) =>
        StandIns.AnsweredDialogs.Ask($"{title}: {folder}");
    public static string SaveFolderPanel(string title, string folder, string defaultName) => throw Absent.Editor;
    public static bool IsPersistent(Object target) => AssetDatabase.Contains(target);
    public static bool IsDirty(Object target) => s_Dirty.Contains(target);

    /// <summary>Takes an object, or all for null, for saved.</summary>
    internal static void ForgetChanges(Object target)
    {
        if (target is null)
            s_Dirty.Clear();
        else
            s_Dirty.Remove(target);
    }

    public static void CopySerialized(Object source, Object dest)
    {
        dest.name = source.name;
        SerializedNode.Of(source).Write(dest, SerializedNode.Of(dest));
        EditorMessages.Validate(dest);
    }

    public static void CopySerializedIfDifferent(Object source, Object dest) => throw Absent.Editor;
    public static void FocusProjectWindow() => throw Absent.Editor;
    public static void RevealInFinder(string path) => StandIns.AnsweredDialogs.Tell(path);
}
