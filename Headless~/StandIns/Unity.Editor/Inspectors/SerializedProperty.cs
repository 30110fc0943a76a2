using System;
using System.Collections.Generic;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine;

namespace UnityEditor;

/// <summary>One saved value of the objects of a <see cref="SerializedObject"/>, by its path.</summary>
public partial class SerializedProperty
{
    private static readonly HashSet<string> s_Expanded = [];

    internal SerializedProperty(SerializedObject owner, string path)
    {
        serializedObject = owner;
        propertyPath = path;
    }

    public SerializedObject serializedObject { get; }
    public string propertyPath { get; }
    public string name => Node.Field != null ? Node.Name : "data";
    public string displayName => Node.Field != null ? Nicely(Node.Name) : "Element " + Node.Name.Trim('[', ']');
    public string tooltip => Node.Field?.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";
    public int depth => propertyPath.Replace(".Array.data", "").Split('.').Length - 1;
    public bool isArray => Node.IsList;
    public bool hasVisibleChildren => Node.Children is { Count: > 0 };
    public bool editable => true;
    public bool prefabOverride { get; set; }
    public bool hasMultipleDifferentValues => !Array.TrueForAll(Nodes, node => node.SameAs(Node));

    public bool isExpanded
    {
        get => s_Expanded.Contains(Key);
        set
        {
            if (value)
                s_Expanded.Add(Key);
            else
                s_Expanded.Remove(Key);
        }
    }

    public int arraySize
    {
        get => Node.IsList ? Node.Children.Count : throw new InvalidOperationException($"'{propertyPath}' is no array.");
        set => Array.ForEach(Nodes, node => node.Resize(value));
    }

    internal SerializedNode Node => Nodes[0];

    internal Type Type => Node.Type;

    internal T Attribute<T>() where T : Attribute => Node.Field?.GetCustomAttribute<T>();

    private string Key => serializedObject.targetObject.GetType().FullName + "/" + propertyPath;

    private SerializedNode[] Nodes => Array.ConvertAll(
        serializedObject.Roots,
        root => root.Find(propertyPath) ?? throw new InvalidOperationException($"'{propertyPath}' has disappeared."));

    public SerializedProperty Copy() => new(serializedObject, propertyPath);

    public SerializedProperty FindPropertyRelative(string relativePropertyPath) =>
        serializedObject.FindProperty($"{propertyPath}.{relativePropertyPath}");

    public SerializedProperty GetArrayElementAtIndex(int index) =>
        index >= 0 && index < arraySize
            ? new SerializedProperty(serializedObject, $"{propertyPath}.Array.data[{index}]")
            : throw new IndexOutOfRangeException($"'{propertyPath}' has {arraySize} elements, not {index + 1}.");

    public void InsertArrayElementAtIndex(int index) => Array.ForEach(Nodes, node => node.InsertAt(index));
    public void DeleteArrayElementAtIndex(int index) => Array.ForEach(Nodes, node => node.RemoveAt(index));
    public void ClearArray() => arraySize = 0;
    public bool MoveArrayElement(int srcIndex, int dstIndex) => throw Absent.Editor;
    public bool Next(bool enterChildren) => throw Absent.Editor;
    public bool NextVisible(bool enterChildren) => throw Absent.Editor;
    public SerializedProperty GetEndProperty() => throw Absent.Editor;
    public SerializedProperty GetEndProperty(bool includeInvisible) => throw Absent.Editor;
    public void Reset() => throw Absent.Editor;
    public static bool DataEquals(SerializedProperty x, SerializedProperty y) => x.Node.SameAs(y.Node);
    public static bool EqualContents(SerializedProperty x, SerializedProperty y) => throw Absent.Editor;

    public void Dispose()
    {
    }

    /// <summary>The children that an inspector shows.</summary>
    internal IEnumerable<SerializedProperty> Children()
    {
        int element = 0;
        foreach (SerializedNode child in Node.Children)
        {
            if (Node.IsList)
                yield return GetArrayElementAtIndex(element++);
            else if (!child.Field.IsDefined(typeof(HideInInspector)))
                yield return FindPropertyRelative(child.Name);
        }
    }

    // "m_PhaseLead" and "phaseLead" are shown as "Phase Lead".
    private static string Nicely(string name)
    {
        name = Regex.Replace(name, "^(m_|_|k(?=[A-Z]))", "");
        name = Regex.Replace(name, "(?<=[a-z0-9])(?=[A-Z])", " ");
        return char.ToUpperInvariant(name[0]) + name[1..];
    }
}
