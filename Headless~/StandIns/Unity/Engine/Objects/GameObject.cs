using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public sealed partial class GameObject : Object
{
    private readonly List<Component> _components = [];
    private readonly Transform _transform;
    private string _tag = "Untagged";
    private bool _activeSelf = true;
    private bool _active = true;
    private int _layer;

    public GameObject() : this("New Game Object")
    {
    }

    public GameObject(string name) : this(name, [])
    {
    }

    public GameObject(string name, params Type[] components)
    {
        this.name = name;
        _transform = new Transform(this);
        _components.Add(_transform);
        SceneRecord.Active.Add(_transform);
        foreach (Type type in components)
        {
            if (type != typeof(Transform))
                AddComponent(type);
        }
    }

    public Transform transform
    {
        get
        {
            CheckAlive();
            return _transform;
        }
    }

    public GameObject gameObject
    {
        get
        {
            CheckAlive();
            return this;
        }
    }

    public Scene scene
    {
        get
        {
            CheckAlive();
            return _transform.Root.Home?.Handle ?? default;
        }
    }

    public string tag
    {
        get
        {
            CheckAlive();
            return _tag;
        }
        set
        {
            CheckAlive();
            _tag = value;
        }
    }

    /// <summary>Scenes of which it is, a bit each: that of all that are loaded here.</summary>
    public ulong sceneCullingMask => 1UL << 63;

    public int layer
    {
        get
        {
            CheckAlive();
            return _layer;
        }
        set
        {
            CheckAlive();
            _layer = value is >= 0 and < 32 ? value : throw new ArgumentOutOfRangeException(nameof(value), "Layers go from 0 to 31.");
        }
    }

    public bool isStatic { get; set; }

    public bool activeSelf
    {
        get
        {
            CheckAlive();
            return _activeSelf;
        }
    }

    public bool activeInHierarchy
    {
        get
        {
            CheckAlive();
            return _active;
        }
    }

    internal IReadOnlyList<Component> Components => _components;

    internal bool ActiveFlag => _active;

    /// <summary>True once the object's end has begun: a second one is not needed.</summary>
    internal bool Dying { get; set; }

    public bool CompareTag(string tag) => this.tag == tag;

    public void SetActive(bool value)
    {
        CheckAlive();
        if (_activeSelf == value)
            return;
        _activeSelf = value;
        Lifecycle.UpdateActivity(_transform);
    }

    public static GameObject Find(string name)
    {
        foreach (GameObject candidate in ObjectRegistry.Find<GameObject>(typeof(GameObject), g => g.ActiveFlag))
        {
            if (candidate.name == name)
                return candidate;
        }

        return null;
    }

    /// <summary>Sets activeInHierarchy from the parent's; true if it changed.</summary>
    internal bool InheritActivity()
    {
        bool active = _activeSelf && (_transform.ParentOrNull?.Owner.ActiveFlag ?? true);
        if (active == _active)
            return false;
        _active = active;
        return true;
    }

    internal void SetActiveQuietly(bool value)
    {
        _activeSelf = value;
        InheritActivity();
    }

    internal void Forget(Component component) => _components.Remove(component);
}
