using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Tests.Shaders;
using Alate.Tests.Views;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>
/// Alate/Wing drawn: the passes of both pipelines that light an insect, translated to WebGL 2 and drawn in Chromium, beside the painter's
/// picture of the same meshes in the same light. Skipped where Chromium, glslang or spirv-cross is not installed. With the variable
/// ALATE_WRITE_SHEETS each test writes what it saw into that folder: from above in the sun and from below against it, by URP, the built-in
/// pipeline and the painter.
/// </summary>
public sealed class WingPictureTests : CrowdFixture
{
    private static readonly int2 s_Size = new(480, 360);
    private static readonly (float Aside, float Above, bool IsAgainstTheLight)[] s_Sides = [(40f, 65f, false), (40f, -38f, true)];

    private readonly List<UnityEngine.Object> m_Materials = [];
    private InsectParts m_Parts;

    private static IEnumerable<string> Species => InsectCatalogue.All.Select(species => species.Name);

    [SetUp]
    public void NeedAll()
    {
        WebTools.NeedChromium();
        WebStages.Need();
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
    }

    [TearDown]
    public void TakeTheParts()
    {
        m_Materials.ForEach(UnityEngine.Object.DestroyImmediate);
        m_Materials.Clear();
        m_Parts?.Destroy();
        m_Parts = null;
        ProjectShaders.Clear();
    }

    [UnityTest, Explicit, Category("Long")]
    public IEnumerator BothPipelines_DrawAnInsect_AsThePainterDoes(
        [ValueSource(nameof(Species))] string species, [Values] bool inverted)
    {
        m_Parts = InsectParts.Make(InsectCatalogue.Find(species), true);
        GameObject insect = Keep(m_Parts.Assemble(m_Parts.CreatePresets(InsectVariant.Standard, ModelReading.Physical)));
        insect.SetActive(true);
        insect.transform.rotation = Quaternion.Euler(-8f, 15f, 4f);
        yield return Frames(23);

        LitSurface[] surfaces = [.. insect.GetComponentsInChildren<MeshRenderer>().Select(Surface)];
        Assert.That(surfaces, Has.Length.GreaterThan(2));
        var pictures = new WebPictures();
        int[] programs = [pictures.Add(false), pictures.Add(true)];
        SheetView[] views = Array.ConvertAll(
            s_Sides, side => SheetView.Of(surfaces, s_Size, side.Aside, side.Above, side.IsAgainstTheLight));
        foreach (SheetView view in views)
        {
            foreach (int program in programs)
                pictures.Add(program, view, surfaces);
        }

        Color32[][] drawn = pictures.Draw(), painted = Array.ConvertAll(views, view => PaintedPicture.Of(view, surfaces));
        WriteSheet($"{species}{(inverted ? "-inverted" : "")}", [drawn[0], drawn[1], painted[0]], [drawn[2], drawn[3], painted[1]]);
        for (int side = 0; side < views.Length; side++)
        {
            AssertAlike(drawn[2 * side], painted[side], 0.008, 0.995, "URP");
            AssertAlike(drawn[2 * side + 1], drawn[2 * side], 0.002, 0.9999, "the built-in pipeline beside URP");
        }

        LitSurface Surface(MeshRenderer renderer)
        {
            Mesh mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
            var surface = new LitSurface(mesh, 0, renderer.sharedMaterial, renderer.transform.localToWorldMatrix);
            return inverted && renderer.sharedMaterial != m_Parts.BodyMaterial ? surface.Inverted(mesh, 0, m_Materials) : surface;
        }
    }

    [UnityTest, Explicit, Category("Long")]
    public IEnumerator ABakedInsect_IsDrawnAsItsFramesAre([Values("monarch", "dragonfly", "firefly")] string species, [Values] bool builtIn)
    {
        m_Parts = InsectParts.Make(InsectCatalogue.Find(species), true);
        Scene = new CrowdScene(species, 1, "cruise", "rest");
        var pose = CrowdPose.At(new float3(0.1f, 0.2f, 0.3f), quaternion.RotateY(0.4f), 0.317f);
        (pose.nextLoop, pose.blend, pose.rate) = (1, 0.2f, 0f);
        Scene.Place(0, pose);
        yield return Frames(3);
        DrawnInstances.Calls = [];
        Scene.Place(0, pose);
        yield return null;

        DrawnBatch[] calls = [.. DrawnInstances.Calls];
        Assert.That(calls, Has.Length.GreaterThan(1));
        LitSurface[] baked = Array.ConvertAll(calls, call => Surface(call)), live = Array.ConvertAll(calls, Posed);
        var texture = (Texture2D)calls[0].Material.GetTexture("_BakeMap");
        var rows = calls[0].Properties.ToDictionary(property => property.Key, property => property.Value[0]);
        var view = SheetView.Of(live, s_Size, 40f, 38f);
        var pictures = new WebPictures();
        pictures.Add(pictures.Add(builtIn, "_BAKED", "INSTANCING_ON"), view, baked, texture, rows);
        pictures.Add(pictures.Add(builtIn), view, live);
        Color32[][] drawn = pictures.Draw();
        WriteSheet($"{species}-baked{(builtIn ? "-built-in" : "")}", drawn);
        AssertAlike(drawn[0], drawn[1], 0.005, 0.99, "baked beside live");

        LitSurface Surface(DrawnBatch call) => new(call.Mesh, call.Submesh, call.Material, call.Matrices[0])
        {
            Texture = m_Parts.Wings.Select(wing => (Texture2D)wing.material.GetTexture("_MainTex"))
                .FirstOrDefault(kept => call.Material.GetTexture("_MainTex") is { } shown && shown.name == kept.name),
        };

        LitSurface Posed(DrawnBatch call)
        {
            int triangles = Enumerable.Range(0, call.Mesh.subMeshCount).Sum(part => call.Mesh.GetTriangles(part).Length / 3);
            ReducedSurface size = ReducedSurface.Of(Scene.Bake, CrowdScene.Triangles).Single(size => size.TriangleCount == triangles);
            BakedFrame[] frames = [.. Scene.Bake.Clips.SelectMany(clip => clip.Frames)];
            Vector4 first = call.Properties["_BakeRows"][0], next = call.Properties["_BakeNextRows"][0];
            LitSurface surface = Surface(call);
            return new LitSurface(call.Mesh, call.Submesh, call.Material, call.Matrices[0])
            {
                Texture = surface.Texture,
                Positions = Array.ConvertAll(size.Vertices, vertex => (Vector3)At(frame => frame.Positions[vertex])),
                Normals = Array.ConvertAll(size.Vertices, vertex => (Vector3)math.normalize(At(frame => frame.Normals[vertex]))),
            };

            float3 At(Func<BakedFrame, float3> of) => math.lerp(Loop(first, of), Loop(next, of), first.w);

            float3 Loop(Vector4 rows, Func<BakedFrame, float3> of) =>
                math.lerp(of(frames[(int)rows.x]), of(frames[(int)rows.y]), rows.z);
        }
    }

    // A square whose picture is a disc of half its width: what is cut lets the paper be seen, and hides what is behind it where it is not.
    [UnityTest, Explicit, Category("Long")]
    public IEnumerator AWingThatIsCut_EndsWhereItsPictureDoes([Values] bool builtIn)
    {
        const int side = 64;
        var disc = new Texture2D(side, side);
        disc.SetPixels32([.. Enumerable.Range(0, side * side).Select(k =>
        {
            float out2 = math.lengthsq(new float2(k % side + 0.5f, k / side + 0.5f) / side - 0.5f);
            return new Color32(255, 0, 0, (byte)(out2 < 0.0625f ? 255 : 0));
        })]);
        var square = new Mesh
        {
            vertices = [new(-1f, 0f, -1f), new(-1f, 0f, 1f), new(1f, 0f, 1f), new(1f, 0f, -1f)],
            normals = [Vector3.up, Vector3.up, Vector3.up, Vector3.up],
            uv = [new(0f, 0f), new(0f, 1f), new(1f, 1f), new(1f, 0f)],
            triangles = [0, 1, 2, 0, 2, 3],
        };
        m_Materials.AddRange([disc, square]);
        LitSurface[] looks = [.. new[] { PictureOpacity.Solid, PictureOpacity.Cut }.Select(opacity =>
        {
            Material material = WingMaterial.Create(WingMaterial.FindShader(), "square", new SurfaceLook(disc, true, opacity));
            m_Materials.Add(material);
            return new LitSurface(square, 0, material, Matrix4x4.identity);
        })];
        yield return null;

        var pictures = new WebPictures();
        int program = pictures.Add(builtIn);
        var view = SheetView.Of(looks, s_Size, 0f, 89f);
        foreach (LitSurface look in looks)
            pictures.Add(program, view, [look]);
        int[] red = [.. pictures.Draw().Select(pixels => pixels.Count(pixel => pixel.r > 2 * pixel.g))];
        Assert.That(red[0], Is.GreaterThan(s_Size.y * s_Size.y / 2), "the whole square");
        Assert.That(red[1], Is.EqualTo(Math.PI / 16.0 * red[0]).Within(4).Percent, "the disc");
    }

    private static void AssertAlike(Color32[] drawn, Color32[] wanted, double difference, double correlation, string what)
    {
        (double off, double brighter, double together) = Compare(drawn, wanted);
        TestContext.Progress.WriteLine(
            $"{TestContext.CurrentContext.Test.Name}, {what}: {100.0 * off:F2} % off, {100.0 * brighter:F2} % brighter, "
            + $"{together:F4} together");
        Assert.That(off, Is.LessThan(difference), $"{what}: mean difference over the range, inside the outline");
        Assert.That(brighter, Is.EqualTo(0.0).Within(0.4 * difference), $"{what}: mean of the differences, with their signs");
        Assert.That(together, Is.GreaterThan(correlation), $"{what}: correlation inside the outline");
    }

    private static (double Difference, double Brighter, double Correlation) Compare(Color32[] drawn, Color32[] wanted)
    {
        Color32 paper = wanted[0];
        List<double> a = [], b = [];
        for (int k = 0; k < wanted.Length; k++)
        {
            if (wanted[k].Equals(paper) && drawn[k].Equals(drawn[0]))
                continue;
            a.AddRange([drawn[k].r, drawn[k].g, drawn[k].b]);
            b.AddRange([wanted[k].r, wanted[k].g, wanted[k].b]);
        }

        Assert.That(a, Has.Count.GreaterThan(wanted.Length / 8), "too little is seen");
        double meanA = a.Average(), meanB = b.Average();
        double Product(List<double> x, double meanX, List<double> y, double meanY) => x.Zip(y, (p, q) => (p - meanX) * (q - meanY)).Sum();
        return (a.Zip(b, (p, q) => Math.Abs(p - q)).Average() / 255.0, (meanA - meanB) / 255.0,
            Product(a, meanA, b, meanB) / Math.Sqrt(Product(a, meanA, a, meanA) * Product(b, meanB, b, meanB)));
    }

    private static void WriteSheet(string name, params Color32[][][] rows)
    {
        string folder = Environment.GetEnvironmentVariable("ALATE_WRITE_SHEETS") ?? "";
        if (folder.Length == 0)
            return;
        Directory.CreateDirectory(folder);
        var sheet = new Texture2D(s_Size.x * rows[0].Length, s_Size.y * rows.Length);
        var pixels = new Color32[sheet.width * sheet.height];
        for (int k = 0; k < pixels.Length; k++)
        {
            int x = k % sheet.width, y = k / sheet.width;
            pixels[(sheet.height - 1 - y) * sheet.width + x] =
                rows[y / s_Size.y][x / s_Size.x][y % s_Size.y * s_Size.x + x % s_Size.x];
        }

        sheet.SetPixels32(pixels);
        File.WriteAllBytes(Path.Combine(folder, name + ".png"), sheet.EncodeToPNG());
        UnityEngine.Object.DestroyImmediate(sheet);
    }
}
