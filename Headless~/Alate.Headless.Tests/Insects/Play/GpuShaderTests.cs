using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Cli;
using Alate.Tests.Shaders;
using Alate.Tests.Views;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Play.Headless;

/// <summary>
/// Wings that the vertex shader of Alate/Wing deforms, run by WebGL 2 in Chromium, beside a twin that the processor deforms: each species
/// in a hundred poses. Skipped where Chromium, glslang or spirv-cross is not installed.
/// </summary>
public sealed class GpuShaderTests : PlayFixture
{
    private const int k_Poses = 100;

    private readonly List<Seen> m_Seen = [];
    private InsectParts m_Parts;

    private static IEnumerable<string> Species => InsectCatalogue.All.Select(species => species.Name);

    /// <summary>A way to compile the shader.</summary>
    public enum Compiled
    {
        Universal,
        UniversalInstanced,
        BuiltInInstanced,
    }

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
        m_Seen.Clear();
        m_Parts?.Destroy();
        m_Parts = null;
        ProjectShaders.Clear();
    }

    [UnityTest, Explicit, Category("Long")]
    public IEnumerator Wings_AreWhereTheProcessorPutsThem([ValueSource(nameof(Species))] string species, [Values] Compiled compiled)
    {
        m_Parts = InsectParts.Make(InsectCatalogue.Find(species), true);
        InsectWings cpu = Stepped(WingSkinning.Cpu), gpu = Stepped(WingSkinning.Gpu);
        yield return Frames(3);
        MeshRenderer[] renderers = [.. gpu.Wings.Select(wing => wing.Renderer).Distinct()];
        foreach (MeshRenderer renderer in renderers)
            m_Seen.Add(new Seen(renderer));
        var random = new Random(5);
        for (int pose = 0; pose < k_Poses; pose++)
        {
            float dt = random.NextFloat(0f, 0.1f);
            Vector3 wind = random.NextFloat3Direction() * random.NextFloat(0f, 3f);
            foreach (InsectWings insect in new[] { cpu, gpu })
            {
                insect.Air.wind = wind;
                insect.Step(dt);
            }

            yield return null;
            for (int k = 0; k < renderers.Length; k++)
            {
                Renderer twin = cpu.Wings.Select(wing => wing.Renderer).Distinct().ElementAt(k);
                m_Seen[k].Add(renderers[k], twin.GetComponent<MeshFilter>().sharedMesh);
            }
        }

        bool builtIn = compiled == Compiled.BuiltInInstanced;
        string[] keywords = compiled == Compiled.Universal ? ["_SKINNED"] : ["_SKINNED", "INSTANCING_ON"];
        (double place, double degrees) = Compare(WebStages.Of(builtIn, keywords).Vertex);
        double moved = CompareMotion(WebStages.OfMotion(builtIn, builtIn ? ["_SKINNED"] : keywords).Vertex);
        TestContext.Progress.WriteLine(
            $"{species}, {compiled}: {m_Seen.Sum(seen => seen.Count)} vertices, {place:E1} of the span, {degrees:F2} degrees, "
            + $"{moved:E1} of the span before");
        // In a range: what is no number is less than all.
        Assert.That(place, Is.InRange(0.0, 2e-6), "of the span");
        Assert.That(moved, Is.InRange(0.0, 2e-6), "of the span, in this picture and the last");
        Assert.That(degrees, Is.InRange(0.0, 0.5), "of which the signed bytes of the processor's normals are 0.4");
    }

    private (double Place, double Degrees) Compare(string program)
    {
        double place = 0.0, degrees = 0.0;
        foreach ((Seen seen, float[] read) in Read(seen => seen.Json(program, 6, "varied_place", "varied_normal")))
        {
            Assert.That(read, Has.Length.EqualTo(6 * seen.Count));
            for (int v = 0; v < seen.Count; v++)
            {
                place = Math.Max(place, math.distance(Number(read, 6 * v), seen.Places[v]) / seen.Span);
                float cosine = math.dot(math.normalize(Number(read, 6 * v + 3)), math.normalize((float3)seen.Normals[v]));
                degrees = Math.Max(degrees, 180.0 / Math.PI * Math.Acos(Math.Min(1.0, cosine)));
            }
        }

        return (place, degrees);
    }

    // The past of each pose is the one before.
    private double CompareMotion(string program)
    {
        double place = 0.0, way = 0.0;
        foreach ((Seen seen, float[] read) in Read(seen => seen.Json(program, 8, "varied_now", "varied_before")))
        {
            int vertices = seen.Count / k_Poses;
            for (int v = vertices; v < seen.Count; v++)
            {
                place = Math.Max(place, math.distance(Number(read, 8 * v), seen.Places[v]) / seen.Span);
                place = Math.Max(place, math.distance(Number(read, 8 * v + 4), seen.Places[v - vertices]) / seen.Span);
                way = Math.Max(way, Vector3.Distance(seen.Places[v], seen.Places[v - vertices]) / seen.Span);
            }
        }

        Assert.That(way, Is.GreaterThan(0.1), "of the span: the poses are the same");
        return place;
    }

    private IEnumerable<(Seen Seen, float[] Read)> Read(Func<Seen, object> call)
    {
        using var folder = new TemporaryFolder();
        string template = File.ReadAllText(
            Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Shaders", "Web", "skin.html"));
        string page = folder.File("skin.html", template.Replace("/*DATA*/", JsonSerializer.Serialize(m_Seen.Select(call))));
        JsonElement result = WebTools.Show(page, folder.Root);
        Assert.That(result.GetProperty("error").ToString(), Is.EqualTo("0"));
        return m_Seen.Zip(
            result.GetProperty("calls").EnumerateArray(),
            (seen, read) => (seen, MemoryMarshal.Cast<byte, float>(read.GetBytesFromBase64()).ToArray())).ToList();
    }

    private static float3 Number(float[] read, int at) => new(read[at], read[at + 1], read[at + 2]);

    private InsectWings Stepped(WingSkinning skinning)
    {
        GameObject made = Keep(m_Parts.Assemble(m_Parts.CreatePresets(InsectVariant.Standard, ModelReading.Physical)));
        InsectWings insect = made.GetComponent<InsectWings>();
        insect.UpdateMode = WingUpdateMode.Manual;
        insect.Quality.skinning = skinning;
        insect.Quality.culling = WingCulling.AlwaysSimulate;
        // The twins have their vertices in one order, the authored one.
        insect.Quality.levelOfDetail = false;
        made.SetActive(true);
        return insect;
    }

    /// <summary>A mesh, its joints in each pose, and where the processor put its vertices.</summary>
    private sealed class Seen
    {
        private readonly Mesh m_Mesh;
        private readonly List<Vector4> m_Corners = [];
        private readonly List<Color> m_Texels = [];
        private readonly int m_Joints;

        public Seen(Renderer renderer)
        {
            m_Mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
            m_Mesh.GetUVs(SkinnedMesh.Channel, m_Corners);
            m_Joints = (int)m_Corners.Max(corner => corner.x + corner.y) + 2;
            Span = math.length((float3)m_Mesh.vertices.Aggregate(Vector3.Max) - (float3)m_Mesh.vertices.Aggregate(Vector3.Min));
        }

        public List<Vector3> Places { get; } = [];

        public List<Vector3> Normals { get; } = [];

        public float Span { get; }

        public int Count => Places.Count;

        public void Add(Renderer renderer, Mesh deformed)
        {
            Color[] texels = ((Texture2D)renderer.sharedMaterial.GetTexture("_SkinMap")).GetPixels();
            m_Texels.AddRange(texels.Skip(2 * GpuSkinReader.Start(renderer)).Take(2 * m_Joints));
            Places.AddRange(deformed.vertices);
            Normals.AddRange(deformed.normals);
        }

        /// <param name="program">The vertex shader.</param>
        /// <param name="numbers">Numbers that are read of a vertex.</param>
        /// <param name="read">Their names.</param>
        public object Json(string program, int numbers, params string[] read)
        {
            int rows = (m_Texels.Count + SkinTable.Width - 1) / SkinTable.Width;
            Color[] texels = [.. m_Texels, .. new Color[rows * SkinTable.Width - m_Texels.Count]];
            float[] identity = [1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f];
            return new
            {
                program,
                numbers,
                read,
                count = m_Mesh.vertexCount,
                poses = Enumerable.Range(0, k_Poses).Select(pose => pose * m_Joints),
                mesh = new
                {
                    position = Text(m_Mesh.vertices),
                    vertex = Text(m_Mesh.vertices),
                    last = Text(new Vector3[m_Mesh.vertexCount]),
                    displacement = Text(new Vector3[m_Mesh.vertexCount]),
                    normal = Text(m_Mesh.normals),
                    skin = Text(m_Corners.ToArray()),
                },
                texture = new { width = SkinTable.Width, height = rows, pixels = Text(texels) },
                uniforms = new Dictionary<string, float[]>
                {
                    ["unity_ObjectToWorld"] = identity,
                    ["unity_ObjectToWorldArray"] = identity,
                    ["unity_MatrixVP"] = identity,
                    ["unity_MatrixPreviousM"] = identity,
                    ["unity_PrevObjectToWorldArray"] = identity,
                    ["_PreviousM"] = identity,
                    ["_NonJitteredViewProjMatrix"] = identity,
                    ["_NonJitteredVP"] = identity,
                    ["_PrevViewProjMatrix"] = identity,
                    ["_PreviousVP"] = identity,
                    ["_SkinLast"] = [-2f * m_Joints],
                    ["_SkinMap_TexelSize"] = [1f / SkinTable.Width, 1f / rows, SkinTable.Width, rows],
                },
            };
        }

        private static string Text<T>(T[] values) where T : struct => Convert.ToBase64String(MemoryMarshal.AsBytes<T>(values));
    }
}
