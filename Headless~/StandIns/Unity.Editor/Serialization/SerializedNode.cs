using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>A saved value as the editor sees it: a leaf, or a list or struct with children.</summary>
internal sealed class SerializedNode
{
    private readonly Type _element;

    private SerializedNode(string name, Type type, FieldInfo field)
    {
        Name = name;
        Type = type;
        Field = field;
        IsList = SerializedFields.IsList(type, out _element);
    }

    public string Name { get; private set; }
    public Type Type { get; }

    /// <summary>Null for elements of lists.</summary>
    public FieldInfo Field { get; }

    public bool IsList { get; }

    /// <summary>Of a leaf.</summary>
    public object Value { get; set; }

    /// <summary>Null for a leaf.</summary>
    public List<SerializedNode> Children { get; private set; }

    /// <summary>All that is saved of an object.</summary>
    public static SerializedNode Of(Object target)
    {
        var root = new SerializedNode("Base", target.GetType(), null) { Children = [] };
        root.ReadFields(target);
        return root;
    }

    public SerializedNode Find(string path)
    {
        SerializedNode node = this;
        foreach (string step in path.Replace(".Array.data[", ".[").Split('.'))
        {
            if (node.Children == null)
                return null;
            string name = step;
            node = node.Children.Find(child => child.Name == name);
            if (node == null)
                return null;
        }

        return node;
    }

    private bool IsNothing => Value is null || (Value is Object o && o == null);

    public SerializedNode Copy()
    {
        var copy = new SerializedNode(Name, Type, Field) { Value = Value };
        copy.Children = Children?.ConvertAll(child => child.Copy());
        return copy;
    }

    public bool SameAs(SerializedNode other)
    {
        if (Children == null)
            return Equals(Value, other.Value) || (IsNothing && other.IsNothing);
        if (Children.Count != other.Children.Count)
            return false;
        for (int i = 0; i < Children.Count; i++)
        {
            if (!Children[i].SameAs(other.Children[i]))
                return false;
        }

        return true;
    }

    /// <summary>Writes the fields that differ from what was read into the object; structs and classes in them are made again.</summary>
    public void Write(object owner, SerializedNode before)
    {
        for (int i = 0; i < Children.Count; i++)
        {
            if (!Children[i].SameAs(before.Children[i]))
                Children[i].Field.SetValue(owner, Children[i].Make());
        }
    }

    /// <summary>Gives a list another length; new elements are copies of the last.</summary>
    public void Resize(int length)
    {
        while (Children.Count > length)
            Children.RemoveAt(Children.Count - 1);
        while (Children.Count < length)
            Children.Add(Children.Count > 0 ? Children[^1].Copy() : Read("", _element, null, null));
        Number();
    }

    public void InsertAt(int index)
    {
        SerializedNode made = Children.Count > 0 ? Children[Math.Min(index, Children.Count - 1)].Copy() : Read("", _element, null, null);
        Children.Insert(index, made);
        Number();
    }

    public void RemoveAt(int index)
    {
        Children.RemoveAt(index);
        Number();
    }

    private void Number()
    {
        for (int i = 0; i < Children.Count; i++)
            Children[i].Name = $"[{i}]";
    }

    private static SerializedNode Read(string name, Type type, FieldInfo field, object value)
    {
        var node = new SerializedNode(name, type, field);
        if (node.IsList)
        {
            node.Children = [];
            foreach (object element in (IEnumerable)value ?? Array.Empty<object>())
                node.Children.Add(Read("", node._element, null, element));
            node.Number();
        }
        else if (SerializedFields.IsInline(type))
        {
            node.Children = [];
            node.ReadFields(value ?? Activator.CreateInstance(type, nonPublic: true));
        }
        else
        {
            node.Value = value ?? (type == typeof(string) ? "" : type.IsValueType ? Activator.CreateInstance(type) : null);
        }

        return node;
    }

    private void ReadFields(object owner)
    {
        foreach (FieldInfo field in SerializedFields.Of(owner.GetType()))
            Children.Add(Read(field.Name, field.FieldType, field, field.GetValue(owner)));
    }

    private object Make()
    {
        if (Children == null)
            return IsNothing ? Nothing(Type) : Value;
        if (IsList)
            return MakeList();
        object made = Activator.CreateInstance(Type, nonPublic: true);
        foreach (SerializedNode child in Children)
            child.Field.SetValue(made, child.Make());
        return made;
    }

    // In the editor an empty reference is an object that only equals null, so that using it can be told from using a null of code.
    private static object Nothing(Type type)
    {
        if (!typeof(Object).IsAssignableFrom(type) || type.IsAbstract)
            return null;
        Object nothing = Factory.Make<Object>(type);
        nothing.MarkDestroyed();
        return nothing;
    }

    private object MakeList()
    {
        var array = Array.CreateInstance(_element, Children.Count);
        for (int i = 0; i < Children.Count; i++)
            array.SetValue(Children[i].Make(), i);
        return Type.IsArray ? array : Activator.CreateInstance(Type, array);
    }
}
