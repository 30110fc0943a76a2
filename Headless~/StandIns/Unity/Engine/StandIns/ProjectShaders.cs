using System.Collections.Generic;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>Shaders that a test's project has besides Unity's own.</summary>
[StandInExtension]
public static class ProjectShaders
{
    private static readonly Dictionary<string, Shader> s_ByName = [];
    private static readonly Dictionary<string, Shader> s_ByResource = [];

    /// <summary>Adds one.</summary>
    /// <param name="name">As in the shader's first line.</param>
    /// <param name="resource">Its path in a Resources folder; null where it lies elsewhere.</param>
    /// <param name="properties">All that it has; null takes those of Unity's shader of the name, or accepts every one.</param>
    public static Shader Add(string name, string resource = null, IReadOnlyCollection<string> properties = null)
    {
        Shader shader = s_ByName[name] = Shader.Create(name, properties);
        if (resource != null)
            s_ByResource[resource] = shader;
        return shader;
    }

    /// <summary>Forgets all of them.</summary>
    public static void Clear()
    {
        s_ByName.Clear();
        s_ByResource.Clear();
    }

    internal static Shader Named(string name) => s_ByName.GetValueOrDefault(name);

    internal static Shader InResources(string path) => s_ByResource.GetValueOrDefault(path);
}
