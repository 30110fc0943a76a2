using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.Json;
using Alate.Cli;
using Alate.Drawing;
using Alate.Tests.Cli;
using Alate.Tests.Views;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Shaders;

/// <summary>Pictures that Alate/Wing draws in WebGL 2, in Chromium.</summary>
internal sealed class WebPictures
{
    private static readonly string[] s_Numbers = ["_VertexColours", "_Through", "_Gloss", "_Shine", "_Cull", "_Translucent"];

    private readonly List<object> m_Programs = [], m_Textures = [], m_Meshes = [], m_Pictures = [];
    private readonly Dictionary<Texture2D, int> m_Places = [];

    /// <summary>[program] The one for surfaces that are cut.</summary>
    private readonly Dictionary<int, int> m_Cuts = [];

    public WebPictures()
    {
        m_Textures.Add(new { half = false, width = 1, height = 1, pixels = Text([new Color32(255, 255, 255, 255)]) });
    }

    /// <summary>Adds both stages of a pass, without and with cut margins; returns its number.</summary>
    /// <param name="builtIn">Of which pipeline.</param>
    /// <param name="keywords">What is set besides.</param>
    public int Add(bool builtIn, params string[] keywords)
    {
        Add(WebStages.Of(builtIn, keywords));
        Add(WebStages.Of(builtIn, [.. keywords, "_CUT"]));
        m_Cuts.Add(m_Programs.Count - 2, m_Programs.Count - 1);
        return m_Programs.Count - 2;
    }

    private void Add(WebStages stages) => m_Programs.Add(new { vertex = stages.Vertex, fragment = stages.Fragment });

    /// <summary>Adds a picture.</summary>
    /// <param name="program">Which pass.</param>
    /// <param name="view">Camera and light.</param>
    /// <param name="surfaces">What is drawn: opaque ones first, then clear ones from the farthest to the nearest.</param>
    /// <param name="bake">Texture of baked loops, or null.</param>
    /// <param name="rows">What an instance says of its loops, by name.</param>
    public void Add(
        int program, SheetView view, IEnumerable<LitSurface> surfaces, Texture2D bake = null,
        IReadOnlyDictionary<string, Vector4> rows = null)
    {
        object[] draws = [.. surfaces
            .OrderBy(surface => surface.IsClear).ThenByDescending(surface => surface.IsClear ? (surface.Middle - view.Eye).magnitude : 0f)
            .Select(surface => Draw(program, surface, bake, rows ?? new Dictionary<string, Vector4>()))];
        float3 paper = Shading.ToLinear(Shading.Paper);
        m_Pictures.Add(new { width = view.Width, height = view.Height, paper = Numbers(paper), draws, uniforms = Uniforms(view) });
    }

    /// <summary>[picture] The pixels, rows from above.</summary>
    public Color32[][] Draw()
    {
        using var folder = new TemporaryFolder();
        string template = File.ReadAllText(
            Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Shaders", "Web", "wing.html"));
        var data = new { programs = m_Programs, textures = m_Textures, meshes = m_Meshes, pictures = m_Pictures };
        string page = folder.File("wing.html", template.Replace("/*DATA*/", JsonSerializer.Serialize(data)));
        JsonElement result = WebTools.Show(page, folder.Root);
        Assert.That(result.GetProperty("error").ToString(), Is.EqualTo("0"));
        return [.. result.GetProperty("pictures").EnumerateArray()
            .Select(picture => PngFile.Read(picture.GetBytesFromBase64()).Pixels)];
    }

    private object Draw(int program, LitSurface surface, Texture2D bake, IReadOnlyDictionary<string, Vector4> rows)
    {
        m_Meshes.Add(new
        {
            position = Text(surface.Positions),
            normal = Text(surface.Normals),
            uv = Text(surface.Uvs),
            baked = Text(surface.Baked),
            colour = Text(Array.ConvertAll(surface.Colours, colour => (Vector4)(Color)colour)),
            triangles = Text(surface.Triangles),
        });
        Dictionary<string, float[]> uniforms = s_Numbers.ToDictionary(name => name, name => new[] { surface.Number(name) });
        uniforms["unity_ObjectToWorld"] = uniforms["unity_ObjectToWorldArray"] = Numbers(surface.Place);
        uniforms["_MainTex_ST"] = [1f, 1f, 0f, 0f];
        Color tint = surface.Tint;
        uniforms["_Color"] = [.. Numbers(LitSurface.Linear(new float3(tint.r, tint.g, tint.b))), tint.a];
        Color below = surface.Underside;
        uniforms["_Underside"] = [.. Numbers(LitSurface.Linear(new float3(below.r, below.g, below.b))), below.a];
        if (bake != null)
            uniforms["_BakeMap_TexelSize"] = [1f / bake.width, 1f / bake.height, bake.width, bake.height];
        foreach ((string name, Vector4 value) in rows)
            uniforms[name] = [value.x, value.y, value.z, value.w];
        return new
        {
            program = surface.IsCut ? m_Cuts[program] : program,
            mesh = m_Meshes.Count - 1,
            paint = surface.Texture == null ? 0 : PlaceOf(surface.Texture),
            bake = bake == null ? 0 : PlaceOf(bake),
            count = surface.Triangles.Length,
            uniforms,
            isClear = surface.IsClear,
            writesDepth = surface.Number("_ZWrite") != 0f,
            cullsBack = surface.Number("_Cull") > 0.5f,
            isMirrored = surface.Place.determinant < 0f,
        };
    }

    private int PlaceOf(Texture2D texture)
    {
        if (m_Places.TryGetValue(texture, out int known))
            return known;
        bool half = texture.format == TextureFormat.RGBAHalf;
        string pixels = half
            ? Text(texture.GetPixels().SelectMany(pixel => new[] { (Half)pixel.r, (Half)pixel.g, (Half)pixel.b, (Half)pixel.a }).ToArray())
            : Text(texture.GetPixels32());
        m_Textures.Add(new { half, texture.width, texture.height, pixels });
        return m_Places[texture] = m_Textures.Count - 1;
    }

    private static Dictionary<string, float[]> Uniforms(SheetView view)
    {
        (float3 ambient, float3 sky) = (SheetView.Ambient, SheetView.Sky);
        float[] sun = [view.ToSun.x, view.ToSun.y, view.ToSun.z, 0f], light = [.. Numbers(SheetView.Sun), 1f];
        return new Dictionary<string, float[]>
        {
            ["unity_MatrixVP"] = Numbers(view.Matrix),
            ["_WorldSpaceCameraPos"] = Numbers(view.Eye),
            ["_MainLightPosition"] = sun,
            ["_WorldSpaceLightPos0"] = sun,
            ["_MainLightColor"] = light,
            ["_LightColor0"] = light,
            ["unity_SHAr"] = [0f, sky.x, 0f, ambient.x],
            ["unity_SHAg"] = [0f, sky.y, 0f, ambient.y],
            ["unity_SHAb"] = [0f, sky.z, 0f, ambient.z],
        };
    }

    // Row by row: the translation multiplies by matrices from the right.
    private static float[] Numbers(Matrix4x4 matrix) =>
        [.. Enumerable.Range(0, 4).Select(matrix.GetRow).SelectMany(row => new[] { row.x, row.y, row.z, row.w })];

    private static float[] Numbers(float3 value) => [value.x, value.y, value.z];

    private static string Text<T>(T[] values) where T : struct => Convert.ToBase64String(MemoryMarshal.AsBytes<T>(values));
}
