using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine;

public sealed partial class GameObject
{
    public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

    public Component AddComponent(Type componentType)
    {
        CheckAlive();
        if (componentType == null || !typeof(Component).IsAssignableFrom(componentType) || componentType.IsAbstract)
            throw new ArgumentException($"{componentType?.Name ?? "null"} is not a component that can be added.", nameof(componentType));
        if (Dying)
        {
            Debug.LogError($"Can't add component '{componentType.Name}' to {name}: the GameObject is being destroyed.", this);
            return null;
        }

        if (Refuses(componentType))
        {
            string what = componentType.Name;
            Debug.LogError($"Can't add '{what}' to {name} because a '{what}' is already added to the game object!", this);
            return null;
        }

        foreach (Type needed in Required(componentType))
        {
            if (GetComponent(needed) is null)
                AddComponent(needed);
        }

        Component component = Factory.Make<Component>(componentType);
        Attach(component);
        Lifecycle.Added(component);
        return component;
    }

    public T GetComponent<T>()
    {
        TryGetComponent(out T component);
        return component;
    }

    public Component GetComponent(Type type)
    {
        TryGetComponent(type, out Component component);
        return component;
    }

    public bool TryGetComponent<T>(out T component)
    {
        CheckAlive();
        foreach (Component candidate in _components)
        {
            if (candidate is T found)
            {
                component = found;
                return true;
            }
        }

        component = default;
        return false;
    }

    public bool TryGetComponent(Type type, out Component component)
    {
        CheckAlive();
        component = _components.Find(type.IsInstanceOfType);
        return component is not null;
    }

    public T[] GetComponents<T>()
    {
        var results = new List<T>();
        GetComponents(results);
        return [.. results];
    }

    public Component[] GetComponents(Type type)
    {
        CheckAlive();
        return [.. _components.FindAll(type.IsInstanceOfType)];
    }

    public void GetComponents<T>(List<T> results)
    {
        CheckAlive();
        results.Clear();
        Collect(results);
    }

    public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);

    public T GetComponentInChildren<T>(bool includeInactive)
    {
        if ((includeInactive || activeInHierarchy) && TryGetComponent(out T own))
            return own;
        for (int i = 0; i < transform.childCount; i++)
        {
            T found = transform.GetChild(i).gameObject.GetComponentInChildren<T>(includeInactive);
            if (found is not null)
                return found;
        }

        return default;
    }

    public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

    public T[] GetComponentsInChildren<T>(bool includeInactive)
    {
        var results = new List<T>();
        GetComponentsInChildren(includeInactive, results);
        return [.. results];
    }

    public void GetComponentsInChildren<T>(List<T> results) => GetComponentsInChildren(false, results);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> results)
    {
        CheckAlive();
        results.Clear();
        CollectInChildren(includeInactive, results);
    }

    public T GetComponentInParent<T>() => GetComponentInParent<T>(false);

    public T GetComponentInParent<T>(bool includeInactive)
    {
        for (Transform t = transform; t is not null; t = t.ParentOrNull)
        {
            if ((includeInactive || t.Owner._active) && t.Owner.TryGetComponent(out T found))
                return found;
        }

        return default;
    }

    public T[] GetComponentsInParent<T>() => GetComponentsInParent<T>(false);

    public T[] GetComponentsInParent<T>(bool includeInactive)
    {
        var results = new List<T>();
        for (Transform t = transform; t is not null; t = t.ParentOrNull)
        {
            if (includeInactive || t.Owner._active)
                t.Owner.Collect(results);
        }

        return [.. results];
    }

    internal void Attach(Component component)
    {
        component.AttachTo(this);
        _components.Add(component);
    }

    /// <summary>The component of this object that cannot be without another one, or null.</summary>
    internal Component Dependent(Component needed)
    {
        foreach (Component candidate in _components)
        {
            foreach (Type type in Required(candidate.GetType()))
            {
                if (type.IsInstanceOfType(needed) && _components.FindAll(type.IsInstanceOfType).Count == 1)
                    return candidate;
            }
        }

        return null;
    }

    private bool Refuses(Type type)
    {
        for (Type t = type; t != null; t = t.BaseType)
        {
            if ((t == typeof(Transform) || t.IsDefined(typeof(DisallowMultipleComponent), false)) && _components.Exists(t.IsInstanceOfType))
                return true;
        }

        return false;
    }

    private static IEnumerable<Type> Required(Type type)
    {
        foreach (RequireComponent required in type.GetCustomAttributes<RequireComponent>(true))
        {
            foreach (Type t in new[] { required.m_Type0, required.m_Type1, required.m_Type2 })
            {
                if (t != null)
                    yield return t;
            }
        }
    }

    private void Collect<T>(List<T> results)
    {
        foreach (Component candidate in _components)
        {
            if (candidate is T found)
                results.Add(found);
        }
    }

    private void CollectInChildren<T>(bool includeInactive, List<T> results)
    {
        if (!includeInactive && !_active)
            return;
        Collect(results);
        foreach (Transform child in _transform.Children)
            child.Owner.CollectInChildren(includeInactive, results);
    }
}
