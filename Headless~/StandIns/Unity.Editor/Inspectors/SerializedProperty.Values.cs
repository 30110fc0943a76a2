using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public partial class SerializedProperty
{
    public SerializedPropertyType propertyType
    {
        get
        {
            Type type = Node.Type;
            if (type.IsEnum)
                return SerializedPropertyType.Enum;
            if (typeof(Object).IsAssignableFrom(type))
                return SerializedPropertyType.ObjectReference;
            return type == typeof(bool) ? SerializedPropertyType.Boolean
                : type == typeof(float) || type == typeof(double) ? SerializedPropertyType.Float
                : type == typeof(string) ? SerializedPropertyType.String
                : type.IsPrimitive ? SerializedPropertyType.Integer
                : type == typeof(Vector3) ? SerializedPropertyType.Vector3
                : type == typeof(Vector4) ? SerializedPropertyType.Vector4
                : SerializedPropertyType.Generic;
        }
    }

    public bool boolValue
    {
        get => Get<bool>();
        set => Set(value);
    }

    /// <summary>Also the number behind an enum.</summary>
    public int intValue
    {
        get => Node.Type.IsEnum ? Convert.ToInt32(Node.Value) : Get<int>();
        set => Set(Node.Type.IsEnum ? Enum.ToObject(Node.Type, value) : value);
    }

    public long longValue { get; set; }

    public float floatValue
    {
        get => Get<float>();
        set => Set(value);
    }

    public double doubleValue { get; set; }

    public string stringValue
    {
        get => Get<string>();
        set => Set(value);
    }

    public int enumValueIndex
    {
        get => Array.IndexOf(Enum.GetValues(Node.Type), Node.Value);
        set => Set(Enum.GetValues(Node.Type).GetValue(value));
    }

    public int enumValueFlag { get; set; }
    public string[] enumDisplayNames => Array.ConvertAll(enumNames, Nicely);
    public string[] enumNames => Enum.GetNames(Node.Type);

    public Vector2 vector2Value { get; set; }

    public Vector3 vector3Value
    {
        get => new(Component("x"), Component("y"), Component("z"));
        set
        {
            SetComponent("x", value.x);
            SetComponent("y", value.y);
            SetComponent("z", value.z);
        }
    }

    public Vector4 vector4Value { get; set; }
    public Quaternion quaternionValue { get; set; }
    public Color colorValue { get; set; }
    public Bounds boundsValue { get; set; }
    public Rect rectValue { get; set; }

    public Object objectReferenceValue
    {
        get => propertyType == SerializedPropertyType.ObjectReference ? (Object)Node.Value : throw WrongType("object reference");
        set
        {
            if (propertyType != SerializedPropertyType.ObjectReference)
                throw WrongType("object reference");
            Set(value == null || Node.Type.IsInstanceOfType(value) ? value : null);
        }
    }

    public object boxedValue { get; set; }

    private T Get<T>() => Node.Type == typeof(T) ? (T)Node.Value : throw WrongType(typeof(T).Name);

    private void Set(object value)
    {
        if (value != null && !Node.Type.IsInstanceOfType(value))
            throw WrongType(value.GetType().Name);
        foreach (SerializedNode node in Nodes)
            node.Value = value;
    }

    private float Component(string name) => FindPropertyRelative(name).floatValue;

    private void SetComponent(string name, float value) => FindPropertyRelative(name).floatValue = value;

    // Unity logs an error and reads zero.
    private InvalidOperationException WrongType(string asked) =>
        new($"type is not a supported {asked} value: '{propertyPath}' is a {Node.Type.Name}.");
}
