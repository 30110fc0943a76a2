using System.Collections.Generic;

namespace UnityEngine.SceneManagement;

/// <summary>A loaded scene: its root objects in order.</summary>
internal sealed class SceneRecord
{
    private static readonly List<SceneRecord> s_Loaded = [];
    private static SceneRecord s_Active;
    private static SceneRecord s_Lasting;
    private static int s_Made;

    private SceneRecord(string name)
    {
        Name = name;
        Handle = new Scene(++s_Made);
    }

    public string Name { get; set; }
    public Scene Handle { get; }
    public List<Transform> Roots { get; } = [];

    /// <summary>The loaded scenes without the one of DontDestroyOnLoad.</summary>
    public static IReadOnlyList<SceneRecord> Loaded => s_Loaded;

    /// <summary>Scene for new objects.</summary>
    public static SceneRecord Active
    {
        get => s_Active ??= s_Loaded.Count > 0 ? s_Loaded[0] : Load("");
        set => s_Active = value;
    }

    /// <summary>The scene of DontDestroyOnLoad.</summary>
    public static SceneRecord Lasting => s_Lasting ??= new SceneRecord("DontDestroyOnLoad");

    public static SceneRecord Load(string name)
    {
        var record = new SceneRecord(name);
        s_Loaded.Add(record);
        return record;
    }

    public static SceneRecord Find(int handle)
    {
        if (handle == 0)
            return null;
        if (s_Lasting?.Handle.handle == handle)
            return s_Lasting;
        return s_Loaded.Find(s => s.Handle.handle == handle);
    }

    public void Add(Transform root)
    {
        root.Home?.Roots.Remove(root);
        root.Home = this;
        Roots.Add(root);
    }

    /// <summary>Destroys the scene's objects; what is marked DontSave lives on in no scene.</summary>
    public void Unload()
    {
        EndRoots();
        if (Roots.Count > 0)
        {
            Debug.LogError("Some objects were not cleaned up when closing the scene. (Did you spawn new GameObjects from OnDestroy?)");
            for (int tries = 0; tries < 100 && Roots.Count > 0; tries++)
                EndRoots();
        }

        s_Loaded.Remove(this);
        if (s_Active == this)
            s_Active = null;
        if (s_Lasting == this)
            s_Lasting = null;
    }

    private void EndRoots()
    {
        foreach (Transform root in Roots.ToArray())
        {
            if (root.IsDestroyed || root.Home != this)
                continue;
            if ((root.Owner.hideFlags & HideFlags.DontSaveInEditor) != 0)
                root.Unlink();
            else
                Lifecycle.Destroy(root.Owner);
        }
    }
}
