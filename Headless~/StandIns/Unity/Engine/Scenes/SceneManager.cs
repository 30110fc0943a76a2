using System;
using UnityEngine.Events;

namespace UnityEngine.SceneManagement;

/// <summary>Scenes made by script; there are none on disk to load.</summary>
public class SceneManager
{
    public static event UnityAction<Scene, LoadSceneMode> sceneLoaded;
    public static event UnityAction<Scene> sceneUnloaded;
    public static event UnityAction<Scene, Scene> activeSceneChanged;

    public static int sceneCount => SceneRecord.Loaded.Count;
    public static int loadedSceneCount => SceneRecord.Loaded.Count;

    public static Scene GetActiveScene() => SceneRecord.Active.Handle;
    public static Scene GetSceneAt(int index) => SceneRecord.Loaded[index].Handle;

    public static Scene GetSceneByName(string name)
    {
        foreach (SceneRecord record in SceneRecord.Loaded)
        {
            if (record.Name == name)
                return record.Handle;
        }

        return default;
    }

    public static bool SetActiveScene(Scene scene)
    {
        SceneRecord before = SceneRecord.Active;
        SceneRecord record = scene.Record
            ?? throw new ArgumentException("SceneManager.SetActiveScene failed; invalid scene.", nameof(scene));
        if (record == before)
            return false;
        SceneRecord.Active = record;
        activeSceneChanged?.Invoke(before.Handle, scene);
        return true;
    }

    public static Scene CreateScene(string sceneName)
    {
        if (string.IsNullOrEmpty(sceneName) || GetSceneByName(sceneName).IsValid())
            throw new ArgumentException($"A scene needs a name that no other has, not '{sceneName}'.", nameof(sceneName));
        _ = SceneRecord.Active;
        return SceneRecord.Load(sceneName).Handle;
    }

    /// <summary>Unloads at once; the last scene stays, as in Unity.</summary>
    public static AsyncOperation UnloadSceneAsync(Scene scene)
    {
        SceneRecord record = scene.Record ?? throw new ArgumentException("Scene to unload is invalid.", nameof(scene));
        if (SceneRecord.Loaded.Count == 1)
        {
            Debug.LogWarning($"Unloading the last loaded scene {record.Name} is not supported.");
            return null;
        }

        record.Unload();
        sceneUnloaded?.Invoke(scene);
        return new AsyncOperation();
    }

    public static void MoveGameObjectToScene(GameObject go, Scene scene)
    {
        if (go.transform.parent != null)
            throw new ArgumentException("Gameobject is not a root in a scene", nameof(go));
        (scene.Record ?? throw new ArgumentException("Destination scene is not valid", nameof(scene))).Add(go.transform);
    }

    /// <summary>A scene as if loaded from disk: makes it, lets the callback fill it, and tells who listens to sceneLoaded.</summary>
    [Unity.StandIns.StandInExtension]
    public static Scene Load(string sceneName, LoadSceneMode mode, Action fill)
    {
        Scene before = GetActiveScene();
        SceneRecord[] others = [.. SceneRecord.Loaded];
        Scene scene = CreateScene(sceneName);
        SetActiveScene(scene);
        fill?.Invoke();
        if (mode == LoadSceneMode.Additive)
        {
            SetActiveScene(before);
        }
        else
        {
            foreach (SceneRecord other in others)
            {
                other.Unload();
                sceneUnloaded?.Invoke(other.Handle);
            }
        }

        sceneLoaded?.Invoke(scene, mode);
        return scene;
    }
}

public enum LoadSceneMode
{
    Single = 0,
    Additive = 1,
}
