using System;
using UnityEditor.SceneManagement;
using Object = UnityEngine.Object;

namespace StandIns;

/// <summary>A prefab that is open for editing, until it is disposed of.</summary>
[Unity.StandIns.StandInExtension]
public sealed class OpenPrefab : IDisposable
{
    public OpenPrefab(string path) => Stage = PrefabStage.Of(path);

    internal static PrefabStage Stage { get; private set; }

    public void Dispose()
    {
        Object.DestroyImmediate(Stage);
        Stage = null;
    }
}
