using System.Linq;
using System.Reflection;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Chooses items of the editor's menus, as a user does.</summary>
internal static class EditorMenu
{
    private static readonly Assembly[] s_Assemblies = [typeof(Alate.Editor.BeatGraph).Assembly, typeof(Alate.Proof.ProofStep).Assembly];

    /// <summary>Chooses an item by its path.</summary>
    public static void Choose(string path, Object context = null)
    {
        MethodInfo item = s_Assemblies.SelectMany(assembly => assembly.GetTypes())
            .SelectMany(type => type.GetMethods(BindingFlags.Static | BindingFlags.NonPublic | BindingFlags.Public))
            .Single(method => method.GetCustomAttributesData().Any(data =>
                data.AttributeType == typeof(MenuItem) && (string)data.ConstructorArguments[0].Value == path
                && (data.ConstructorArguments.Count < 2 || !(bool)data.ConstructorArguments[1].Value)));
        item.Invoke(null, item.GetParameters().Length == 0 ? null : [new MenuCommand(context)]);
    }
}
