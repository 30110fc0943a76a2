using UnityEngine;

namespace Unity.StandIns;

/// <summary>Messages of the editor to components while the user works.</summary>
[StandInExtension]
public static class EditorMessages
{
    /// <summary>A field was changed in the inspector.</summary>
    public static void Validate(Object changed)
    {
        BehaviourMessages messages = changed switch
        {
            MonoBehaviour behaviour => behaviour.Messages,
            ScriptableObject asset => new BehaviourMessages(asset),
            _ => null,
        };
        messages?.Send("OnValidate");
    }

    /// <summary>Reset was chosen in the component's menu.</summary>
    public static void Reset(MonoBehaviour behaviour)
    {
        behaviour.Messages.Send("Reset");
        Validate(behaviour);
    }

    /// <summary>A scene view is drawn with an object selected, or none.</summary>
    public static void DrawGizmos(GameObject selected)
    {
        foreach (MonoBehaviour behaviour in Object.FindObjectsByType<MonoBehaviour>(FindObjectsSortMode.InstanceID))
        {
            if (!behaviour.enabled)
                continue;
            Gizmos.matrix = Matrix4x4.identity;
            Gizmos.color = Color.white;
            behaviour.Messages.Send("OnDrawGizmos");
            if (selected != null && behaviour.transform.IsChildOf(selected.transform))
                behaviour.Messages.Send("OnDrawGizmosSelected");
        }
    }
}
