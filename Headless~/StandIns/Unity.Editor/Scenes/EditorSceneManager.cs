using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement;

public sealed class EditorSceneManager : SceneManager
{
    public static bool MarkSceneDirty(Scene scene) => throw Absent.Editor;
    public static void MarkAllScenesDirty() => throw Absent.Editor;
    public static Scene OpenScene(string scenePath) => throw Absent.Editor;
    public static bool SaveScene(Scene scene) => throw Absent.Editor;
    public static bool SaveScene(Scene scene, string dstScenePath) => throw Absent.Editor;
    public static bool SaveScene(Scene scene, string dstScenePath, bool saveAsCopy) => throw Absent.Editor;
    public static Scene NewScene(NewSceneSetup setup) => throw Absent.Editor;
    public static Scene NewScene(NewSceneSetup setup, NewSceneMode mode) => throw Absent.Editor;
    public static Scene NewPreviewScene() => throw Absent.Editor;
    public static bool ClosePreviewScene(Scene scene) => throw Absent.Editor;
}
