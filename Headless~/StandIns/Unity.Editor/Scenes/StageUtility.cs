using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject) => throw Absent.Editor;
    public static StageHandle GetCurrentStageHandle() => throw Absent.Editor;
    public static bool IsGameObjectRenderedByCamera(GameObject gameObject, Camera camera) => throw Absent.Editor;
}
