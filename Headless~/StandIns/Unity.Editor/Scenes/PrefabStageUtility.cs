namespace UnityEditor.SceneManagement;

public static class PrefabStageUtility
{
    public static PrefabStage GetCurrentPrefabStage() => StandIns.OpenPrefab.Stage;
}
