using UnityEngine;

namespace UnityEditor.SceneManagement;

public sealed class PrefabStage : PreviewSceneStage
{
    private string _assetPath;

    public override string assetPath => _assetPath;

    internal static PrefabStage Of(string path)
    {
        PrefabStage stage = CreateInstance<PrefabStage>();
        stage._assetPath = path;
        return stage;
    }
}

public abstract class PreviewSceneStage : Stage
{
}

public abstract class Stage : ScriptableObject
{
    public virtual string assetPath => "";
}
