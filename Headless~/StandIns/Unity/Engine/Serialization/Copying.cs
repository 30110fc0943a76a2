using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine;

/// <summary>Copies objects as Instantiate does: saved content, with references inside the copied hierarchy led to the copies.</summary>
internal static class Copying
{
    public static T Copy<T>(T original, Transform parent, bool worldPositionStays, (Vector3 Position, Quaternion Rotation)? place)
        where T : Object
    {
        if (original == null)
            throw new ArgumentException("The Object you want to instantiate is null.");
        switch ((Object)original)
        {
            case GameObject gameObject:
                return (T)(Object)Hierarchy(gameObject, parent, worldPositionStays, place)[gameObject];
            case Component component:
                return (T)Hierarchy(component.gameObject, parent, worldPositionStays, place)[component];
            case ScriptableObject asset:
                return (T)(Object)Asset(asset);
            default:
                return (T)((ICopyable)original).Copy();
        }
    }

    /// <summary>Copies the saved fields of one object to another of the same type.</summary>
    public static void Fields(object from, object to, IReadOnlyDictionary<Object, Object> copies)
    {
        (from as ISerializationCallbackReceiver)?.OnBeforeSerialize();
        foreach (FieldInfo field in SerializedFields.Of(from.GetType()))
            field.SetValue(to, Value(field.GetValue(from), field.FieldType, copies));
        (to as ISerializationCallbackReceiver)?.OnAfterDeserialize();
    }

    /// <summary>The copy of an object if it was copied too, else the object.</summary>
    public static Object Twin(Object original, IReadOnlyDictionary<Object, Object> copies) =>
        original is not null && copies.TryGetValue(original, out Object copy) ? copy : original;

    private static ScriptableObject Asset(ScriptableObject original)
    {
        ScriptableObject copy = Factory.Make<ScriptableObject>(original.GetType());
        copy.name = original.name + "(Clone)";
        copy.hideFlags = original.hideFlags;
        Fields(original, copy, new Dictionary<Object, Object>());
        copy.Begin();
        return copy;
    }

    private static Dictionary<Object, Object> Hierarchy(
        GameObject original, Transform parent, bool worldPositionStays, (Vector3 Position, Quaternion Rotation)? place)
    {
        var copies = new Dictionary<Object, Object>(ReferenceEqualityComparer.Instance);
        GameObject copy = Shell(original, null, copies);
        copy.name = original.name + "(Clone)";
        foreach ((Object from, Object to) in new List<KeyValuePair<Object, Object>>(copies))
        {
            if (from is Component component and not Transform)
                State(component, (Component)to, copies);
        }

        if (parent != null)
            copy.transform.SetParent(parent, worldPositionStays);
        if (place is { } at)
            copy.transform.SetPositionAndRotation(at.Position, at.Rotation);

        copy.SetActiveQuietly(original.activeSelf);
        Lifecycle.InheritQuietly(copy.transform);
        var awaking = new List<MonoBehaviour>();
        foreach (Object made in copies.Values)
        {
            if (made is MonoBehaviour behaviour && behaviour.Owner.ActiveFlag)
                awaking.Add(behaviour);
        }

        Lifecycle.Activate(awaking);
        return copies;
    }

    // The new objects sleep until all their fields are filled.
    private static GameObject Shell(GameObject original, Transform parent, Dictionary<Object, Object> copies)
    {
        var copy = new GameObject(original.name) { tag = original.tag, layer = original.layer, hideFlags = original.hideFlags };
        copy.SetActiveQuietly(false);
        if (parent is not null)
            copy.transform.SetParent(parent, false);
        Transform place = original.transform;
        copy.transform.localPosition = place.localPosition;
        copy.transform.localRotation = place.localRotation;
        copy.transform.localScale = place.localScale;
        copies.Add(original, copy);
        copies.Add(place, copy.transform);
        foreach (Component component in original.Components)
        {
            if (component is Transform)
                continue;
            Component twin = Factory.Make<Component>(component.GetType());
            copy.Attach(twin);
            copies.Add(component, twin);
        }

        foreach (Transform child in place.Children)
            Shell(child.Owner, copy.transform, copies);
        if (parent is not null)
            copy.SetActiveQuietly(original.activeSelf);
        return copy;
    }

    private static void State(Component from, Component to, Dictionary<Object, Object> copies)
    {
        to.hideFlags = from.hideFlags;
        (from as IStateful)?.CopyStateTo(to);
        if (from is Behaviour behaviour)
            ((Behaviour)to).SetEnabledQuietly(behaviour.enabled);
        (to as IReferring)?.Redirect(copies);
        Fields(from, to, copies);
    }

    private static object Value(object value, Type type, IReadOnlyDictionary<Object, Object> copies)
    {
        if (value is null)
            return Missing(type);
        if (value is Object o)
            return Twin(o, copies);
        if (type.IsPrimitive || type.IsEnum || value is string)
            return value;
        if (SerializedFields.IsList(type, out Type element))
            return List((IList)value, type, element, copies);
        object twin = Activator.CreateInstance(value.GetType(), nonPublic: true);
        Fields(value, twin, copies);
        return twin;
    }

    private static object List(IList from, Type type, Type element, IReadOnlyDictionary<Object, Object> copies)
    {
        IList to = type.IsArray
            ? Array.CreateInstance(element, from.Count)
            : (IList)Activator.CreateInstance(type);
        for (int i = 0; i < from.Count; i++)
        {
            object value = Value(from[i], element, copies);
            if (type.IsArray)
                to[i] = value;
            else
                to.Add(value);
        }

        return to;
    }

    // Unity never saves null for what is saved in place.
    private static object Missing(Type type)
    {
        if (type == typeof(string))
            return "";
        if (SerializedFields.IsList(type, out Type element))
            return type.IsArray ? Array.CreateInstance(element, 0) : Activator.CreateInstance(type);
        return SerializedFields.IsInline(type) ? Activator.CreateInstance(type, nonPublic: true) : null;
    }
}

/// <summary>An asset of the engine that can make its own copy.</summary>
internal interface ICopyable
{
    Object Copy();
}

/// <summary>A component of the engine that refers to objects by other means than a serialised field.</summary>
internal interface IReferring
{
    /// <summary>Told to a copy: what it refers to may have been copied with it.</summary>
    void Redirect(IReadOnlyDictionary<Object, Object> copies);
}

/// <summary>A component of the engine with state that is no serialised field.</summary>
internal interface IStateful
{
    void CopyStateTo(Component copy);
}
