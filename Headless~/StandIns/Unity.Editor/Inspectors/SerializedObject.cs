using System;
using System.Collections.Generic;
using System.Reflection;
using Unity.StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The saved fields of one or more objects of one type: read when it is made or updated, written when applied.</summary>
public class SerializedObject
{
    private readonly SerializedNode[] _read;
    private readonly SerializedNode[] _edited;

    public SerializedObject(Object obj) : this([obj])
    {
    }

    public SerializedObject(Object[] objs)
    {
        if (objs.Length == 0 || Array.Exists(objs, o => o == null))
            throw new ArgumentException("Object at index 0 is null");
        targetObjects = objs;
        _read = new SerializedNode[objs.Length];
        _edited = new SerializedNode[objs.Length];
        Update();
    }

    public Object targetObject => targetObjects[0];
    public Object[] targetObjects { get; }
    public bool isEditingMultipleObjects => targetObjects.Length > 1;
    public bool hasModifiedProperties => Array.Exists(_edited, node => !node.SameAs(_read[Array.IndexOf(_edited, node)]));

    internal SerializedNode[] Roots => _edited;

    public void Update()
    {
        for (int i = 0; i < targetObjects.Length; i++)
        {
            _read[i] = SerializedNode.Of(targetObjects[i]);
            _edited[i] = _read[i].Copy();
        }
    }

    public bool UpdateIfRequiredOrScript()
    {
        bool required = false;
        for (int i = 0; i < targetObjects.Length; i++)
            required |= !SerializedNode.Of(targetObjects[i]).SameAs(_read[i]);
        Update();
        return required;
    }

    public bool ApplyModifiedProperties() => Apply(true);
    public bool ApplyModifiedPropertiesWithoutUndo() => Apply(false);

    public SerializedProperty FindProperty(string propertyPath) =>
        _edited[0].Find(propertyPath) == null ? null : new SerializedProperty(this, propertyPath);

    /// <summary>The fields that an inspector shows.</summary>
    internal IEnumerable<SerializedProperty> Visible()
    {
        foreach (SerializedNode field in _edited[0].Children)
        {
            if (!field.Field.IsDefined(typeof(HideInInspector)))
                yield return FindProperty(field.Name);
        }
    }

    public SerializedProperty GetIterator() => throw Absent.Editor;
    public void SetIsDifferentCacheDirty() => throw Absent.Editor;

    public void Dispose()
    {
    }

    private bool Apply(bool undoable)
    {
        bool changed = false;
        for (int i = 0; i < targetObjects.Length; i++)
        {
            if (_edited[i].SameAs(_read[i]))
                continue;
            changed = true;
            if (undoable)
                Undo.RecordObject(targetObjects[i], "Inspector");
            _edited[i].Write(targetObjects[i], _read[i]);
            _read[i] = _edited[i].Copy();
            EditorMessages.Validate(targetObjects[i]);
        }

        return changed;
    }
}
