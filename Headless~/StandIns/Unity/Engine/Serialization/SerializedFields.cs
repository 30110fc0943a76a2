using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine;

/// <summary>Fields that Unity saves: public or [SerializeField], of types that it can write.</summary>
internal static class SerializedFields
{
    private static readonly ConcurrentDictionary<Type, FieldInfo[]> s_Known = [];

    /// <summary>The saved fields of a type, those of base classes first.</summary>
    public static FieldInfo[] Of(Type type) => s_Known.GetOrAdd(type, Find);

    /// <summary>
    /// Returns true where a field keeps its value when scripts are compiled again: private ones do too, where their type can be written.
    /// </summary>
    public static bool SurvivesReload(FieldInfo field) =>
        IsSaved(field)
        || (!field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute)) && IsWritable(field.FieldType, inList: false));

    /// <summary>A struct or class whose fields are saved in place.</summary>
    public static bool IsInline(Type type) =>
        !type.IsPrimitive && !type.IsEnum && type != typeof(string) && !typeof(Object).IsAssignableFrom(type)
        && !typeof(Delegate).IsAssignableFrom(type) && !type.IsAbstract && !type.IsInterface
        && ((type.IsDefined(typeof(SerializableAttribute), false) && type.Assembly != typeof(object).Assembly) || IsEngineStruct(type));

    public static bool IsList(Type type, out Type element)
    {
        bool isList = type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>);
        bool isArray = type.IsSZArray;
        element = isList ? type.GetGenericArguments()[0] : isArray ? type.GetElementType() : null;
        return element != null;
    }

    private static FieldInfo[] Find(Type type)
    {
        const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        var fields = new List<FieldInfo>();
        for (Type t = type; t != null && t != typeof(object) && !IsEngineClass(t); t = t.BaseType)
            fields.InsertRange(0, Array.FindAll(t.GetFields(own), IsSaved));
        return [.. fields];
    }

    private static bool IsSaved(FieldInfo field)
    {
        if (field.IsInitOnly || field.IsDefined(typeof(NonSerializedAttribute)))
            return false;
        if (field.IsDefined(typeof(SerializeReference)))
            return true;
        bool asked = field.IsPublic || field.IsDefined(typeof(SerializeField)) || IsEngineStruct(field.DeclaringType);
        return asked && IsWritable(field.FieldType, inList: false);
    }

    private static bool IsWritable(Type type, bool inList)
    {
        if (type.IsPrimitive || type.IsEnum || type == typeof(string) || typeof(Object).IsAssignableFrom(type))
            return true;
        if (IsList(type, out Type element))
            return !inList && IsWritable(element, inList: true);
        return IsInline(type);
    }

    private static bool IsEngineClass(Type type) =>
        type.Assembly == typeof(Object).Assembly && !type.IsValueType && type.Namespace == "UnityEngine";

    private static bool IsEngineStruct(Type type) =>
        type is { IsValueType: true, IsPrimitive: false, IsEnum: false } && type.Assembly == typeof(Object).Assembly
        && (type.Namespace == "UnityEngine" || type.Namespace == "Unity.Mathematics");
}
