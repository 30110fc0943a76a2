using System;
using System.Collections.Generic;
using Unity.StandIns;

namespace UnityEngine;

public sealed class Shader : Object
{
    private static readonly string[] s_BuiltIn =
    [
        "Standard", "Diffuse", "Unlit/Color", "Unlit/Texture", "Sprites/Default", "Hidden/Internal-Colored",
    ];

    private static readonly Dictionary<string, Shader> s_Found = [];
    private static readonly Dictionary<string, int> s_Ids = [];

    public bool isSupported => true;
    public int renderQueue => 2000;

    /// <summary>Names of the properties; null accepts every name.</summary>
    internal IReadOnlyCollection<string> Properties { get; private init; }

    /// <summary>One of the built-in render pipeline's or of <see cref="ProjectShaders"/>, or null.</summary>
    public static Shader Find(string name)
    {
        if (ProjectShaders.Named(name) is { } added)
            return added;
        if (Array.IndexOf(s_BuiltIn, name) < 0)
            return null;
        if (!s_Found.TryGetValue(name, out Shader shader) || shader == null)
            s_Found[name] = shader = Create(name);
        return shader;
    }

    public static int PropertyToID(string name)
    {
        if (!s_Ids.TryGetValue(name, out int id))
            s_Ids.Add(name, id = s_Ids.Count + 1);
        return id;
    }

    internal static string NameOf(int id)
    {
        foreach ((string name, int known) in s_Ids)
        {
            if (known == id)
                return name;
        }

        return null;
    }

    internal static Shader Create(string name, IReadOnlyCollection<string> properties = null) =>
        new() { name = name, Properties = properties ?? ShaderProperties.Of(name) };
}
