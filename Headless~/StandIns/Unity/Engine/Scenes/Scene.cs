using System.Collections.Generic;

namespace UnityEngine.SceneManagement;

public struct Scene
{
    private int _handle;

    internal Scene(int handle) => _handle = handle;

    public int handle => _handle;
    public string name
    {
        get => Record?.Name ?? "";
        set => Record.Name = value;
    }

    public string path => "";
    public int buildIndex => -1;
    public bool isLoaded => Record != null;
    public int rootCount => Record?.Roots.Count ?? 0;

    internal SceneRecord Record => SceneRecord.Find(_handle);

    public static bool operator ==(Scene lhs, Scene rhs) => lhs._handle == rhs._handle;
    public static bool operator !=(Scene lhs, Scene rhs) => lhs._handle != rhs._handle;

    public bool IsValid() => Record != null;

    public GameObject[] GetRootGameObjects()
    {
        var roots = new List<GameObject>();
        GetRootGameObjects(roots);
        return [.. roots];
    }

    public void GetRootGameObjects(List<GameObject> rootGameObjects)
    {
        rootGameObjects.Clear();
        foreach (Transform root in Record.Roots)
            rootGameObjects.Add(root.Owner);
    }

    public override bool Equals(object other) => other is Scene scene && scene == this;
    public override int GetHashCode() => _handle;
}
