using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.Json;
using Alate.Cli;
using Alate.Crowds;
using Alate.Tests.Cli;
using Alate.Tests.Shaders;
using Alate.Tests.Views;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>
/// Motion vectors of Alate/Wing as its own code computes them in WebGL 2, against the difference of two pictures: of a beating insect that
/// flies past a moving camera, live and baked. Skipped where Chromium or glslang is not installed.
/// </summary>
public sealed class MotionShaderTests : CrowdFixture
{
    private const float k_Turn = 0.02f;

    private RenderPipelineAsset m_Pipeline;

    private static string Shaders => Path.Combine(PackageRoot.Find(), "Runtime", "Catalogue", "Materials", "Resources", "Alate");

    [SetUp]
    public void UseAPipeline()
    {
        WebTools.NeedChromium();
        if (Glslang.Path == null)
            Assert.Ignore("glslang is not installed.");
        GraphicsSettings.defaultRenderPipeline = m_Pipeline = ScriptableObject.CreateInstance<UniversalRenderPipelineAsset>();
    }

    [TearDown]
    public void UseTheBuiltInPipeline()
    {
        GraphicsSettings.defaultRenderPipeline = null;
        UnityEngine.Object.DestroyImmediate(m_Pipeline);
    }

    [UnityTest, Explicit, Category("Long")]
    public IEnumerator OfALiveWing_TheyAreTheDifferenceOfTwoPictures([Values] bool builtIn)
    {
        InsectWings insect = Insect(1f);
        insect.Quality.motionVectors = true;
        yield return Frames(12);

        var calls = new List<Call>();
        for (int picture = 0; picture < 2; picture++)
        {
            Transform wing = insect.Wings[0].Renderer.transform;
            Mesh mesh = insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh;
            var displacements = new List<Vector4>();
            mesh.GetUVs(5, displacements);
            calls.Add(new Call(picture, calls.LastOrDefault())
            {
                Positions = mesh.vertices,
                Displacements = [.. displacements],
                Place = wing.localToWorldMatrix,
            });
            insect.transform.SetPositionAndRotation(new Vector3(0.004f, 0.002f, 0.003f), Quaternion.Euler(1f, 2f, 3f));
            yield return null;
        }

        Compare(Read(Program(builtIn), calls));
    }

    [UnityTest, Explicit, Category("Long")]
    public IEnumerator OfABakedInsect_TheyAreTheDifferenceOfTwoPictures([Values] bool builtIn)
    {
        Scene = new CrowdScene("monarch", 1, "cruise", "rest");
        Scene.Crowd.MotionVectors = true;
        var batches = new List<DrawnBatch>();
        for (int picture = 0; picture < 5; picture++)
        {
            var pose = CrowdPose.At(
                new float3(0.004f * picture, 0f, 0.002f * picture), quaternion.RotateY(0.03f * picture), 0.31f + 0.07f * picture);
            (pose.nextLoop, pose.blend, pose.rate) = (1, 0.2f, 0f);
            Scene.Place(0, pose);
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;
            if (DrawnInstances.Calls.Count > 0)
                batches.Add(DrawnInstances.Calls[0]);
        }

        var calls = new List<Call>();
        foreach (DrawnBatch batch in batches.TakeLast(2))
        {
            calls.Add(new Call(calls.Count, calls.LastOrDefault())
            {
                Positions = batch.Mesh.vertices,
                Coordinates = batch.Mesh.uv2,
                Texture = (Texture2D)batch.Material.GetTexture("_BakeMap"),
                Place = batch.Matrices[0],
                LastPlace = batch.LastMatrices[0],
                Rows = ["_BakeRows", "_BakeNextRows", "_BakeLastRows", "_BakeLastNextRows"],
                Batch = batch,
            });
        }

        Compare(Read(Program(builtIn, builtIn ? ["_BAKED"] : ["_BAKED", "INSTANCING_ON"]), calls));
    }

    // The second picture twice, at last with no displacements or rows: then the beat must be missing.
    private static float[][] Read(string program, List<Call> calls)
    {
        using var folder = new TemporaryFolder();
        string template = File.ReadAllText(
            Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Shaders", "Web", "motion.html"));
        object[] draws = [calls[0].Json(program, true), calls[1].Json(program, true), calls[1].Json(program, false)];
        string page = folder.File("motion.html", template.Replace("/*DATA*/", JsonSerializer.Serialize(draws)));
        JsonElement result = WebTools.Show(page, folder.Root);
        Assert.That(result.GetProperty("error").ToString(), Is.EqualTo("0"));
        return [.. result.GetProperty("read").EnumerateArray().Select(draw => draw.EnumerateArray().Select(n => n.GetSingle()).ToArray())];
    }

    private static void Compare(float[][] read)
    {
        float missing = 0f, largest = 0f;
        for (int vertex = 0; vertex < read[0].Length / 6; vertex++)
        {
            // Upwards on the screen is downwards in the picture's texture.
            float2 wanted = 0.5f * (Shown(read[1], vertex) - Shown(read[0], vertex)) * new float2(1f, -1f);
            float length = math.length(wanted);
            Assert.That(math.distance(Motion(read[1], vertex), wanted), Is.LessThan(0.01f * length + 2e-6f), $"vertex {vertex}");
            missing = math.max(missing, math.distance(Motion(read[2], vertex), wanted));
            largest = math.max(largest, length);
        }

        Assert.That(largest, Is.GreaterThan(0.01f), "of the picture");
        Assert.That(missing, Is.GreaterThan(0.1f * largest), "the beat is a part of it");
    }

    private static float2 Shown(float[] read, int vertex) =>
        new float2(read[6 * vertex], read[6 * vertex + 1]) / read[6 * vertex + 3];

    private static float2 Motion(float[] read, int vertex) => new(read[6 * vertex + 4], read[6 * vertex + 5]);

    private static string Program(bool builtIn, params string[] keywords)
    {
        var shader = new ShaderFile(File.ReadAllText(Path.Combine(Shaders, "Wing.shader")));
        ShaderFile.SubShader taken = shader.SubShaders.First(sub => builtIn ? sub.Universal == null : sub.Takes(new Version(17, 1, 0)));
        string includes = Path.Combine(
            PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Shaders", "Includes", builtIn ? "BuiltIn" : "Universal");
        using var folder = new TemporaryFolder();
        string file = folder.File("motion.hlsl", taken.Passes.Single(pass => pass.LightMode == "MotionVectors").Program);
        return VertexGlsl.Of(file, [Shaders, includes], keywords.Append("STANDIN_URP=1701"));
    }

    /// <summary>Draw call of one picture, with the last one's.</summary>
    private sealed class Call(int picture, Call last)
    {
        private static readonly Matrix4x4 s_Lens = Matrix4x4.Perspective(40f, 1.6f, 0.01f, 10f);

        public Vector3[] Positions { get; init; }

        public Vector4[] Displacements { get; init; } = [];

        public Vector2[] Coordinates { get; init; } = [];

        public Texture2D Texture { get; init; }

        public Matrix4x4 Place { get; init; }

        public Matrix4x4? LastPlace { get; init; }

        public string[] Rows { get; init; } = [];

        public DrawnBatch Batch { get; init; }

        private Matrix4x4 Eye => s_Lens * Matrix4x4.Translate(new Vector3(0.003f * picture, 0f, -0.4f))
            * Matrix4x4.Rotate(Quaternion.Euler(25f, 30f + Mathf.Rad2Deg * k_Turn * picture, 0f));

        public object Json(string program, bool knows)
        {
            Matrix4x4 place = LastPlace ?? last?.Place ?? Place, eye = last?.Eye ?? Eye;
            var uniforms = new Dictionary<string, float[]>
            {
                // The jitter of antialiasing is no motion.
                ["unity_MatrixVP"] = Numbers(Matrix4x4.Translate(new Vector3(0.01f, -0.02f, 0f)) * Eye),
                ["unity_ObjectToWorld"] = Numbers(Place),
                ["unity_Builtins0Array[0].unity_ObjectToWorldArray"] = Numbers(Place),
                ["unity_MatrixPreviousM"] = Numbers(place),
                ["_PreviousM"] = Numbers(place),
                ["unity_Builtins3Array[0].unity_PrevObjectToWorldArray"] = Numbers(place),
                ["_NonJitteredViewProjMatrix"] = Numbers(Eye),
                ["_NonJitteredVP"] = Numbers(Eye),
                ["_PrevViewProjMatrix"] = Numbers(eye),
                ["_PreviousVP"] = Numbers(eye),
                ["unity_MotionVectorsParams"] = [0f, 1f, 0f, 0f],
            };
            if (Texture != null)
                uniforms["_BakeMap_TexelSize"] = [1f / Texture.width, 1f / Texture.height, Texture.width, Texture.height];
            foreach (string rows in Rows.Take(knows ? 4 : 2))
            {
                Vector4 value = Batch.Properties[rows][0];
                string buffer = rows.Contains("Last") ? "AlateBakedLastArray[0]." : "AlateBakedArray[0].";
                uniforms[rows] = uniforms[buffer + rows] = [value.x, value.y, value.z, value.w];
            }

            return new
            {
                vertex = program,
                count = Positions.Length,
                positions = Text(Positions),
                displacements = Text(Halves(knows ? Displacements : [], Positions.Length)),
                coordinates = Text(Coordinates.Length > 0 ? Coordinates : new Vector2[Positions.Length]),
                width = Texture == null ? 1 : Texture.width,
                height = Texture == null ? 1 : Texture.height,
                pixels = Text(Texture == null ? new Half[4] : Halves([.. Texture.GetPixels().Select(pixel => (Vector4)pixel)], 0)),
                uniforms,
            };
        }

        private static Half[] Halves(Vector4[] values, int count) => values.Length == 0 ? new Half[4 * count]
            : [.. values.SelectMany(value => new[] { (Half)value.x, (Half)value.y, (Half)value.z, (Half)value.w })];

        private static float[] Numbers(Matrix4x4 matrix) =>
            [.. Enumerable.Range(0, 4).Select(matrix.GetColumn).SelectMany(column => new[] { column.x, column.y, column.z, column.w })];

        private static string Text<T>(T[] values) where T : struct => Convert.ToBase64String(MemoryMarshal.AsBytes<T>(values));
    }
}
