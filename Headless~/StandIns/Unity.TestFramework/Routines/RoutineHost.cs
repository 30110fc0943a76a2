using UnityEngine;

namespace Unity.StandIns;

/// <summary>The object on which a test's routine runs.</summary>
internal sealed class RoutineHost : MonoBehaviour
{
    public static RoutineHost Create()
    {
        var host = new GameObject("Test") { hideFlags = HideFlags.HideAndDontSave };
        Object.DontDestroyOnLoad(host);
        return host.AddComponent<RoutineHost>();
    }

    public void End()
    {
        if (this != null)
            DestroyImmediate(gameObject);
    }
}
