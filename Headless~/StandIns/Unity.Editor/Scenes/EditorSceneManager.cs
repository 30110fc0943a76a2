using StandIns;
using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement;

public sealed class EditorSceneManager : SceneManager
{
    public static bool MarkSceneDirty(Scene scene) => throw Absent.Editor;
    public static void MarkAllScenesDirty() => throw Absent.Editor;
    public static Scene OpenScene(string scenePath)
    {
        RunningEditor.Scenes.Add(scenePath);
        return default;
    }

    public static bool SaveScene(Scene scene) => throw Absent.Editor;
    public static bool SaveScene(Scene scene, string dstScenePath)
    {
        RunningEditor.Scenes.Add(dstScenePath);
        return true;
    }

    public static bool SaveScene(Scene scene, string dstScenePath, bool saveAsCopy) => throw Absent.Editor;
    public static Scene NewScene(NewSceneSetup setup) => throw Absent.Editor;
    public static Scene NewScene(NewSceneSetup setup, NewSceneMode mode) => throw Absent.Editor;
    public static Scene NewPreviewScene() => throw Absent.Editor;
    public static bool ClosePreviewScene(Scene scene) => throw Absent.Editor;
}
