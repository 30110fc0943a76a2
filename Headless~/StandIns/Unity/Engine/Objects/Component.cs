using System;
using System.Collections.Generic;

namespace UnityEngine;

public class Component : Object
{
    private GameObject _gameObject;

    public Component()
    {
        // As in Unity, what has no object equals null from the start.
        if (!Factory.Announce(this, "Components can only be added using AddComponent()."))
            MarkDestroyed();
    }

    public GameObject gameObject
    {
        get
        {
            CheckAlive();
            return _gameObject;
        }
    }

    public Transform transform => gameObject.transform;

    public string tag
    {
        get => gameObject.tag;
        set => gameObject.tag = value;
    }

    private protected override string Name
    {
        get => _gameObject is null ? "" : _gameObject.name;
        set => _gameObject.name = value;
    }

    /// <summary>The owner, also of a destroyed component.</summary>
    internal GameObject Owner => _gameObject;

    public bool CompareTag(string tag) => gameObject.CompareTag(tag);

    public T GetComponent<T>() => gameObject.GetComponent<T>();
    public Component GetComponent(Type type) => gameObject.GetComponent(type);
    public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);
    public bool TryGetComponent(Type type, out Component component) => gameObject.TryGetComponent(type, out component);
    public T[] GetComponents<T>() => gameObject.GetComponents<T>();
    public Component[] GetComponents(Type type) => gameObject.GetComponents(type);
    public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);

    public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();
    public T GetComponentInChildren<T>(bool includeInactive) => gameObject.GetComponentInChildren<T>(includeInactive);
    public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();
    public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);
    public void GetComponentsInChildren<T>(List<T> results) => gameObject.GetComponentsInChildren(results);
    public void GetComponentsInChildren<T>(bool includeInactive, List<T> result) =>
        gameObject.GetComponentsInChildren(includeInactive, result);

    public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();
    public T GetComponentInParent<T>(bool includeInactive) => gameObject.GetComponentInParent<T>(includeInactive);
    public T[] GetComponentsInParent<T>() => gameObject.GetComponentsInParent<T>();
    public T[] GetComponentsInParent<T>(bool includeInactive) => gameObject.GetComponentsInParent<T>(includeInactive);

    internal void AttachTo(GameObject owner) => _gameObject = owner;
}
