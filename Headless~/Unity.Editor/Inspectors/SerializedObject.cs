using UnityEngine;

namespace UnityEditor;

public class SerializedObject
{
    public SerializedObject(Object obj)
    {
    }

    public SerializedObject(Object[] objs)
    {
    }

    public Object targetObject { get; }
    public Object[] targetObjects { get; }
    public bool isEditingMultipleObjects { get; }
    public bool hasModifiedProperties { get; }

    public void Update() => throw Absent.Editor;
    public bool UpdateIfRequiredOrScript() => throw Absent.Editor;
    public bool ApplyModifiedProperties() => throw Absent.Editor;
    public bool ApplyModifiedPropertiesWithoutUndo() => throw Absent.Editor;
    public SerializedProperty FindProperty(string propertyPath) => throw Absent.Editor;
    public SerializedProperty GetIterator() => throw Absent.Editor;
    public void SetIsDifferentCacheDirty() => throw Absent.Editor;
    public void Dispose() => throw Absent.Editor;
}
