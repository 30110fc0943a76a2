using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Sends objects their messages as they awake, start, are disabled and end.</summary>
internal static class Lifecycle
{
    private static readonly List<GameObject> s_Postponed = [];

    /// <summary>A component was added by script.</summary>
    public static void Added(Component component)
    {
        if (component is not MonoBehaviour behaviour)
            return;
        if (behaviour.Owner.ActiveFlag)
            Activate(behaviour);
        if (Application.isPlaying || behaviour.IsDestroyed)
            return;
        behaviour.Messages.Send("Reset");
        behaviour.Messages.Send("OnValidate");
    }

    /// <summary>Awake if it has not, and OnEnable if it is enabled. Whoever throws in Awake is disabled.</summary>
    public static void Activate(MonoBehaviour behaviour)
    {
        if (behaviour.Ended || !behaviour.Owner.ActiveFlag || !behaviour.HearsMessages)
            return;
        if (!behaviour.Awoken)
        {
            behaviour.Awoken = true;
            if (!behaviour.Messages.Send(behaviour.Messages.Awake))
                behaviour.SetEnabledQuietly(false);
        }

        if (behaviour.Ended || behaviour.Live || !behaviour.EnabledFlag || !behaviour.Owner.ActiveFlag)
            return;
        behaviour.Live = true;
        BehaviourList.Add(behaviour);
        behaviour.Messages.Send(behaviour.Messages.OnEnable);
    }

    public static void Start(MonoBehaviour behaviour)
    {
        if (behaviour.Started || !behaviour.Live)
            return;
        behaviour.Started = true;
        behaviour.Messages.Send(behaviour.Messages.Start);
        if (behaviour.Live && behaviour.Messages.StartRoutine is { } routine)
            behaviour.StartCoroutine(routine());
    }

    public static void Deactivate(MonoBehaviour behaviour)
    {
        if (!behaviour.Live)
            return;
        behaviour.Live = false;
        BehaviourList.Remove(behaviour);
        behaviour.Messages.Send(behaviour.Messages.OnDisable);
    }

    /// <summary>Lets a change of activity run down the hierarchy.</summary>
    public static void UpdateActivity(Transform top)
    {
        var awaking = new List<MonoBehaviour>();
        var sleeping = new List<MonoBehaviour>();
        Collect(top, awaking, sleeping);
        foreach (MonoBehaviour behaviour in sleeping)
        {
            // One who slept before may have woken it.
            if (behaviour.Owner.ActiveFlag)
                continue;
            Deactivate(behaviour);
            behaviour.StopAllCoroutines();
        }

        Activate(awaking);
    }

    /// <summary>Behaviours that come to life together, as of a scene or a copy.</summary>
    public static void Activate(List<MonoBehaviour> batch)
    {
        batch.RemoveAll(b => b.Live);
        BehaviourList.Sort(batch);
        foreach (MonoBehaviour behaviour in batch)
            Activate(behaviour);
    }

    public static void ParentChanged(Transform child)
    {
        if (child.IsDestroyed)
            return;
        foreach (MonoBehaviour behaviour in child.Owner.GetComponentsInChildren<MonoBehaviour>())
        {
            if (behaviour.HearsMessages)
                behaviour.Messages.Send("OnTransformParentChanged");
        }
    }

    /// <summary>Ends an object at once.</summary>
    public static void Destroy(Object doomed)
    {
        switch (doomed)
        {
            case GameObject gameObject:
                Destroy(gameObject);
                break;
            case Transform transform:
                Debug.LogError($"Can't destroy Transform component of '{transform.name}'. Destroy the game object instead.", transform);
                break;
            case Component component:
                Destroy(component);
                break;
            case ScriptableObject asset:
                asset.End();
                break;
            default:
                doomed.MarkDestroyed();
                break;
        }
    }

    private static void Destroy(GameObject gameObject)
    {
        if (gameObject.Dying)
            return;
        var parts = new List<Transform>();
        CollectHierarchy(gameObject.transform, parts);
        var ending = new List<MonoBehaviour>();
        foreach (Transform part in parts)
            ending.AddRange(part.Owner.GetComponents<MonoBehaviour>());
        if (parts.Exists(p => p.Owner.Dying) || ending.Exists(b => b.Ended))
        {
            // One of them is hearing of its own end: let it hear all.
            s_Postponed.Add(gameObject);
            return;
        }

        foreach (Transform part in parts)
            part.Owner.Dying = true;

        foreach (MonoBehaviour behaviour in ending)
            behaviour.Ended = true;
        foreach (MonoBehaviour behaviour in ending)
            Deactivate(behaviour);
        foreach (MonoBehaviour behaviour in ending)
            SendOnDestroy(behaviour);

        gameObject.transform.Unlink();
        foreach (Transform part in parts)
        {
            foreach (Component component in part.Owner.Components)
                component.MarkDestroyed();
            part.Owner.MarkDestroyed();
        }

        DestroyPostponed();
    }

    private static void DestroyPostponed()
    {
        GameObject[] postponed = [.. s_Postponed];
        s_Postponed.Clear();
        foreach (GameObject next in postponed)
        {
            if (!next.IsDestroyed)
                Destroy(next);
        }
    }

    private static void Destroy(Component component)
    {
        GameObject owner = component.Owner;
        if (owner.Dying)
            return;
        if (owner.Dependent(component) is { } dependent)
        {
            Debug.LogError($"Can't remove {component.GetType().Name} because {dependent.GetType().Name} depends on it", component);
            return;
        }

        if (component is MonoBehaviour behaviour)
        {
            if (behaviour.Ended)
                return;
            behaviour.Ended = true;
            Deactivate(behaviour);
            SendOnDestroy(behaviour);
        }

        owner.Forget(component);
        component.MarkDestroyed();
        DestroyPostponed();
    }

    private static void SendOnDestroy(MonoBehaviour behaviour)
    {
        if (!behaviour.Awoken || !behaviour.HearsMessages)
            return;
        behaviour.Messages.Send(behaviour.Messages.OnDestroy);
    }

    private static void Collect(Transform part, List<MonoBehaviour> awaking, List<MonoBehaviour> sleeping)
    {
        if (!part.Owner.InheritActivity())
            return;
        foreach (Component component in part.Owner.Components)
        {
            if (component is MonoBehaviour behaviour)
                (part.Owner.ActiveFlag ? awaking : sleeping).Add(behaviour);
        }

        foreach (Transform child in part.Children)
            Collect(child, awaking, sleeping);
    }

    /// <summary>Sets activity down the hierarchy; nobody is told.</summary>
    public static void InheritQuietly(Transform top)
    {
        top.Owner.InheritActivity();
        foreach (Transform child in top.Children)
            InheritQuietly(child);
    }

    private static void CollectHierarchy(Transform top, List<Transform> parts)
    {
        parts.Add(top);
        foreach (Transform child in top.Children)
            CollectHierarchy(child, parts);
    }
}
