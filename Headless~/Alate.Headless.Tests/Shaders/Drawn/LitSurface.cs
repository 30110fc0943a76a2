using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Shaders;

/// <summary>One draw call of Alate/Wing: corners as a mesh holds them, where they are placed, and the numbers of the material.</summary>
internal sealed class LitSurface
{
    private static readonly Dictionary<string, float> s_Defaults = Regex
        .Matches(WebStages.Text, @"(_\w+) \(""[^""]*"", (?:Float|Range\([^)]*\))\) = ([\d.]+)")
        .ToDictionary(number => number.Groups[1].Value, number => float.Parse(number.Groups[2].Value, CultureInfo.InvariantCulture));

    private readonly Material m_Material;

    /// <param name="mesh">Its corners.</param>
    /// <param name="submesh">Which of its triangles.</param>
    /// <param name="material">Its colours and light.</param>
    /// <param name="place">From the mesh to the world.</param>
    public LitSurface(Mesh mesh, int submesh, Material material, Matrix4x4 place)
    {
        m_Material = material;
        Positions = mesh.vertices;
        Normals = mesh.normals;
        Uvs = mesh.uv.Length > 0 ? mesh.uv : new Vector2[Positions.Length];
        Baked = mesh.uv2;
        Colours = mesh.colors32.Length > 0
            ? mesh.colors32
            : [.. Enumerable.Repeat(new Color32(255, 255, 255, 255), Positions.Length)];
        Triangles = mesh.GetTriangles(submesh);
        Place = place;
        Texture = material.HasProperty("_MainTex") ? (Texture2D)material.GetTexture("_MainTex") : null;
        Tint = material.HasProperty("_Color") ? material.GetColor("_Color") : Color.white;
        Underside = material.HasProperty("_Underside") ? material.GetColor("_Underside") : new Color(1f, 1f, 1f, 0f);
        IsClear = Number("_DstBlend") != 0f;
        IsCut = material.IsKeywordEnabled(WingShaders.Cut);
    }

    public Vector3[] Positions { get; init; }

    public Vector3[] Normals { get; init; }

    public Vector2[] Uvs { get; }

    /// <summary>[vertex] Its place in the texture of the baked loops.</summary>
    public Vector2[] Baked { get; }

    public Color32[] Colours { get; }

    public int[] Triangles { get; }

    public Matrix4x4 Place { get; }

    /// <summary>Null is white.</summary>
    public Texture2D Texture { get; init; }

    /// <summary>sRGB.</summary>
    public Color Tint { get; init; }

    /// <summary>Colour of the lower side, sRGB, and how far it goes.</summary>
    public Color Underside { get; }

    /// <summary>True where things behind it are seen through it.</summary>
    public bool IsClear { get; }

    /// <summary>True where the opacity of its texture is its outline.</summary>
    public bool IsCut { get; }

    /// <summary>Middle of its corners in the world.</summary>
    public Vector3 Middle => Positions.Aggregate(Vector3.zero, (sum, place) => sum + Place.MultiplyPoint3x4(place)) / Positions.Length;

    /// <summary>Number of the material, the shader's own where it has none.</summary>
    public float Number(string name) => m_Material.HasProperty(name) ? m_Material.GetFloat(name) : s_Defaults[name];

    /// <summary>Returns this one seen through where it was opaque, and opaque where it was seen through.</summary>
    /// <param name="mesh">Its mesh.</param>
    /// <param name="submesh">Which of its triangles.</param>
    /// <param name="made">Where its material is noted, to be destroyed.</param>
    public LitSurface Inverted(Mesh mesh, int submesh, ICollection<UnityEngine.Object> made)
    {
        Material other = WingMaterial.Create(m_Material.shader, m_Material.name, new SurfaceLook(
            Texture, true, IsClear ? PictureOpacity.Solid : PictureOpacity.Clear));
        made.Add(other);
        return new LitSurface(mesh, submesh, other, Place)
        {
            Positions = Positions,
            Normals = Normals,
            Tint = new Color(Tint.r, Tint.g, Tint.b, IsClear ? 1f : 0.55f),
        };
    }

    /// <summary>Light of an sRGB value.</summary>
    public static float Linear(float encoded) =>
        (float)(encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4));

    /// <inheritdoc cref="Linear(float)"/>
    public static float3 Linear(float3 encoded) => new(Linear(encoded.x), Linear(encoded.y), Linear(encoded.z));
}
