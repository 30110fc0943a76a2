using UnityEngine;

namespace UnityEditor;

public class SerializedProperty
{
    public SerializedObject serializedObject { get; }
    public string name { get; }
    public string displayName { get; }
    public string propertyPath { get; }
    public SerializedPropertyType propertyType { get; }
    public string tooltip { get; }
    public int depth { get; }
    public bool isArray { get; }
    public int arraySize { get; set; }
    public bool isExpanded { get; set; }
    public bool prefabOverride { get; set; }
    public bool hasMultipleDifferentValues { get; }
    public bool hasVisibleChildren { get; }
    public bool editable { get; }
    public bool boolValue { get; set; }
    public int intValue { get; set; }
    public long longValue { get; set; }
    public float floatValue { get; set; }
    public double doubleValue { get; set; }
    public string stringValue { get; set; }
    public int enumValueIndex { get; set; }
    public int enumValueFlag { get; set; }
    public string[] enumDisplayNames { get; }
    public string[] enumNames { get; }
    public Vector2 vector2Value { get; set; }
    public Vector3 vector3Value { get; set; }
    public Vector4 vector4Value { get; set; }
    public Quaternion quaternionValue { get; set; }
    public Color colorValue { get; set; }
    public Bounds boundsValue { get; set; }
    public Rect rectValue { get; set; }
    public Object objectReferenceValue { get; set; }
    public object boxedValue { get; set; }

    public SerializedProperty Copy() => throw Absent.Editor;
    public bool Next(bool enterChildren) => throw Absent.Editor;
    public bool NextVisible(bool enterChildren) => throw Absent.Editor;
    public SerializedProperty GetEndProperty() => throw Absent.Editor;
    public SerializedProperty GetEndProperty(bool includeInvisible) => throw Absent.Editor;
    public SerializedProperty FindPropertyRelative(string relativePropertyPath) => throw Absent.Editor;
    public SerializedProperty GetArrayElementAtIndex(int index) => throw Absent.Editor;
    public void InsertArrayElementAtIndex(int index) => throw Absent.Editor;
    public void DeleteArrayElementAtIndex(int index) => throw Absent.Editor;
    public bool MoveArrayElement(int srcIndex, int dstIndex) => throw Absent.Editor;
    public void ClearArray() => throw Absent.Editor;
    public void Reset() => throw Absent.Editor;
    public static bool DataEquals(SerializedProperty x, SerializedProperty y) => throw Absent.Editor;
    public static bool EqualContents(SerializedProperty x, SerializedProperty y) => throw Absent.Editor;
    public void Dispose() => throw Absent.Editor;
}
