using UnityEngine;

namespace UnityEditor.SceneManagement;

public struct StageHandle
{
    public bool Contains(GameObject gameObject) => throw Absent.Editor;
    public bool IsValid() => throw Absent.Editor;
}
