namespace UnityEditor.SceneManagement;

public enum NewSceneSetup
{
    EmptyScene = 0,
    DefaultGameObjects = 1,
}
