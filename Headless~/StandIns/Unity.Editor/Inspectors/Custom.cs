using System;
using System.Linq;
using System.Reflection;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Finds the editors and drawers that the program's assemblies declare, also those that no code has run of yet.</summary>
internal static class Custom
{
    private static readonly string s_Editor = typeof(Custom).Assembly.GetName().Name;

    private static readonly Lazy<Type[]> s_Types = new(() => [.. AppDomain.CurrentDomain.GetAssemblies()
        .Where(UsesTheEditor)
        .SelectMany(assembly => assembly.GetReferencedAssemblies().Select(Assembly.Load).Where(UsesTheEditor).Append(assembly))
        .Distinct()
        .SelectMany(assembly => assembly.GetTypes())]);

    // The first type of each declares it.
    private static readonly Lazy<ILookup<Type, Type>> s_Editors = new(() => s_Types.Value
        .Where(type => type.IsDefined(typeof(CustomEditor)))
        .ToLookup(type => type.GetCustomAttribute<CustomEditor>().Inspected));

    private static readonly Lazy<ILookup<Type, Type>> s_Drawers = new(() => s_Types.Value
        .SelectMany(type => type.GetCustomAttributes<CustomPropertyDrawer>(), (type, drawer) => (drawer.Drawn, type))
        .ToLookup(pair => pair.Drawn, pair => pair.type));

    /// <summary>The editor of some objects of one type; the plain one where none is declared.</summary>
    public static Type EditorOf(Object[] targets)
    {
        Type editor = s_Editors.Value[targets[0].GetType()].FirstOrDefault();
        if (editor == null)
            return typeof(Editor);
        if (targets.Length > 1 && !editor.IsDefined(typeof(CanEditMultipleObjects)))
            throw new NotSupportedException($"{editor.Name} cannot edit several objects.");
        return editor;
    }

    private static bool UsesTheEditor(Assembly assembly) => assembly.GetReferencedAssemblies().Any(name => name.Name == s_Editor);

    /// <summary>A new drawer of a field's type; null for none.</summary>
    public static PropertyDrawer DrawerOf(Type drawn)
    {
        Type drawer = s_Drawers.Value[drawn].FirstOrDefault();
        return drawer == null ? null : (PropertyDrawer)Activator.CreateInstance(drawer, nonPublic: true);
    }
}
