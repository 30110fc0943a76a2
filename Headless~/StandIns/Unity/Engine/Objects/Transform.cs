using System.Collections;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine;

/// <summary>Place in a hierarchy: parents, children, order. Space is in the other part.</summary>
public partial class Transform : Component, IEnumerable
{
    private readonly List<Transform> _children = [];
    private Transform _parent;

    protected Transform()
    {
    }

    internal Transform(GameObject owner) => AttachTo(owner);

    public Transform parent
    {
        get
        {
            CheckAlive();
            return _parent;
        }
        set => SetParent(value, true);
    }

    public Transform root
    {
        get
        {
            CheckAlive();
            return Root;
        }
    }

    public int childCount
    {
        get
        {
            CheckAlive();
            return _children.Count;
        }
    }

    public int hierarchyCount
    {
        get
        {
            int count = 1;
            foreach (Transform child in _children)
                count += child.hierarchyCount;
            return count;
        }
    }

    internal IReadOnlyList<Transform> Children => _children;

    internal Transform ParentOrNull => _parent;

    internal Transform Root => _parent is null ? this : _parent.Root;

    /// <summary>The scene of a root; null for one that has outlived its scene, and for children.</summary>
    internal SceneRecord Home { get; set; }

    private List<Transform> Siblings => _parent is null ? Home?.Roots : _parent._children;

    public void SetParent(Transform p) => SetParent(p, true);

    public void SetParent(Transform parent, bool worldPositionStays)
    {
        CheckAlive();
        if (parent == null)
            parent = null;
        if (ReferenceEquals(parent, _parent))
            return;
        if (parent is not null && parent.IsChildOf(this))
        {
            Debug.LogError("Cannot set the parent of a transform to one of its own children.", this);
            return;
        }

        if (Owner.Dying || parent is { Owner.Dying: true })
        {
            Debug.LogError($"Cannot set the parent of the GameObject '{Name}' while it or the parent is being destroyed.", this);
            return;
        }

        Matrix4x4 world = worldPositionStays ? localToWorldMatrix : default;
        Quaternion worldRotation = worldPositionStays ? rotation : default;
        SceneRecord scene = Root.Home;
        Unlink();
        _parent = parent;
        if (parent is null)
            (scene ?? SceneRecord.Active).Add(this);
        else
            parent._children.Add(this);
        if (worldPositionStays)
            KeepPlace(world, worldRotation);
        MarkChanged();
        Lifecycle.UpdateActivity(this);
        Lifecycle.ParentChanged(this);
    }

    public bool IsChildOf(Transform parent)
    {
        for (Transform t = this; t is not null; t = t._parent)
        {
            if (ReferenceEquals(t, parent))
                return true;
        }

        return false;
    }

    public Transform GetChild(int index)
    {
        CheckAlive();
        return (uint)index < (uint)_children.Count ? _children[index] : throw new UnityException("Transform child out of bounds");
    }

    /// <summary>A child by name, or a descendant by names with slashes between; null if there is none.</summary>
    public Transform Find(string n)
    {
        CheckAlive();
        Transform found = this;
        foreach (string part in n.Split('/'))
        {
            found = found._children.Find(c => c.Name == part);
            if (found is null)
                return null;
        }

        return found;
    }

    public void DetachChildren()
    {
        while (childCount > 0)
            _children[^1].SetParent(null, true);
    }

    public int GetSiblingIndex() => Siblings?.IndexOf(this) ?? 0;

    public void SetSiblingIndex(int index)
    {
        List<Transform> siblings = Siblings;
        if (siblings == null)
            return;
        siblings.Remove(this);
        siblings.Insert(Mathf.Clamp(index, 0, siblings.Count), this);
    }

    public void SetAsFirstSibling() => SetSiblingIndex(0);
    public void SetAsLastSibling() => SetSiblingIndex(int.MaxValue);

    public IEnumerator GetEnumerator()
    {
        for (int i = 0; i < childCount; i++)
            yield return GetChild(i);
    }

    internal void Unlink()
    {
        Siblings?.Remove(this);
        Home = null;
        _parent = null;
    }
}
