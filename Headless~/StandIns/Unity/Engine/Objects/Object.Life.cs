using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public partial class Object
{
    /// <summary>Ends the object, or a component, when the frame ends.</summary>
    public static void Destroy(Object obj) => Destroy(obj, 0f);

    public static void Destroy(Object obj, float t)
    {
        MainThread.Check(nameof(Destroy));
        if (IsNull(obj))
            return;
        if (!Application.isPlaying)
            Debug.LogError("Destroy may not be called from edit mode! Use DestroyImmediate instead.", obj);
        else
            Doomed.Add(obj, t);
    }

    public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

    public static void DestroyImmediate(Object obj, bool allowDestroyingAssets)
    {
        MainThread.Check(nameof(DestroyImmediate));
        if (!IsNull(obj))
            Lifecycle.Destroy(obj);
    }

    public static void DontDestroyOnLoad(Object target)
    {
        Transform top = target switch { GameObject g => g.transform, Component c => c.transform, _ => null };
        if (top == null)
            return;
        if (top.parent != null)
        {
            Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.", target);
        }
        else if (!Application.isPlaying)
        {
            throw new InvalidOperationException("The following game object is invoking the DontDestroyOnLoad method: "
                + $"{target.name}. Notice that DontDestroyOnLoad can only be used in play mode.");
        }
        else
        {
            SceneRecord.Lasting.Add(top);
        }
    }

    public static T Instantiate<T>(T original) where T : Object => Copying.Copy(original, null, false, null);

    public static T Instantiate<T>(T original, Transform parent) where T : Object => Instantiate(original, parent, false);

    public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays) where T : Object =>
        Copying.Copy(original, parent, worldPositionStays, null);

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation) where T : Object =>
        Copying.Copy(original, null, false, (position, rotation));

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent) where T : Object =>
        Copying.Copy(original, parent, false, (position, rotation));

    public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode) where T : Object =>
        FindObjectsByType<T>(FindObjectsInactive.Exclude, sortMode);

    public static T[] FindObjectsByType<T>(FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode) where T : Object
    {
        bool inactiveToo = findObjectsInactive == FindObjectsInactive.Include;
        List<T> found = ObjectRegistry.Find<T>(typeof(T), o => IsFindable(o, inactiveToo));
        return [.. found];
    }

    public static T FindFirstObjectByType<T>() where T : Object => FindFirstObjectByType<T>(FindObjectsInactive.Exclude);

    public static T FindFirstObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object
    {
        T[] found = FindObjectsByType<T>(findObjectsInactive, FindObjectsSortMode.InstanceID);
        return found.Length > 0 ? found[0] : null;
    }

    public static T FindAnyObjectByType<T>() where T : Object => FindFirstObjectByType<T>();

    public static T FindAnyObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object =>
        FindFirstObjectByType<T>(findObjectsInactive);

    private static bool IsFindable(Object o, bool inactiveToo)
    {
        GameObject owner = o as GameObject ?? (o as Component)?.Owner;
        HideFlags flags = owner is null ? o._hideFlags : owner._hideFlags | o._hideFlags;
        return (flags & HideFlags.DontSave) != HideFlags.DontSave && (inactiveToo || owner is null || owner.ActiveFlag);
    }
}

public enum FindObjectsSortMode
{
    None = 0,
    InstanceID = 1,
}

public enum FindObjectsInactive
{
    Exclude = 0,
    Include = 1,
}
