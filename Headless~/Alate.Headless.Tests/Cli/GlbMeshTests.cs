using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Formats;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Wings and bodies of GLB files, which these tests put together from the specification of glTF 2.0.</summary>
public sealed class GlbMeshTests
{
    private CommandRun m_Run;

    [SetUp]
    public void MakeFolder() => m_Run = new CommandRun();

    [TearDown]
    public void RemoveFolder() => m_Run.Dispose();

    // A node turns, stretches and moves its mesh; its parent mirrors it: upper sides stay upper sides.
    [TestCase(1f)]
    [TestCase(-1f)]
    public void AMesh_IsWhereItsNodesPutIt_WithItsUpperSideUp_AndItsPicture(float mirror)
    {
        SurfaceMesh wing = Wing();
        byte[] png = TrueColourPng.Write(4, 2, [.. Enumerable.Repeat(new Color32(9, 80, 200, 255), 8)], []);
        var turn = quaternion.RotateY(0.7f);
        var child = new JsonObject
        {
            ["mesh"] = 0,
            ["rotation"] = Numbers(turn.value.x, turn.value.y, turn.value.z, turn.value.w),
            ["scale"] = Numbers(2f, 2f, 2f),
            ["translation"] = Numbers(0.1f, 0.2f, 0.3f),
        };
        string file = Write(wing, png, child, new JsonObject { ["children"] = new JsonArray(0), ["scale"] = Numbers(mirror, 1f, 1f) });
        var read = GlbMesh.Read(file);

        Assert.That(read.Picture, Is.EqualTo(png));
        Assert.That(read.Surface.uvs, Is.EqualTo(wing.uvs).Using<Vector2>((a, b) => (a - b).magnitude < 1e-6f));
        Assert.That(read.Surface.colours, Is.Null, "white");
        for (int k = 0; k < wing.positions.Length; k++)
        {
            float3 place = new float3(0.1f, 0.2f, 0.3f) + math.rotate(turn, 2f * Gltf(wing.positions[k]));
            Assert.That(math.distance((float3)read.Surface.positions[k], Gltf(new float3(mirror, 1f, 1f) * place)), Is.LessThan(1e-6f));
        }

        for (int k = 0; k < read.Surface.triangles.Length; k += 3)
        {
            Vector3 a = At(k), b = At(k + 1), c = At(k + 2);
            Assert.That(Vector3.Cross(b - a, c - a).y, Is.GreaterThan(0f));
        }

        Vector3 At(int corner) => read.Surface.positions[read.Surface.triangles[corner]];
    }

    [Test]
    public void AWingAndABody_BecomeAnInsectThatFlies_WithThePicture()
    {
        byte[] png = TrueColourPng.Write(32, 32, [.. Enumerable.Repeat(new Color32(9, 80, 200, 255), 32 * 32)], []);
        string wing = Write(Wing(), png, new JsonObject { ["mesh"] = 0 });
        SurfaceMesh thorax = InsectCatalogue.Find("fishfly").Body.CreateSurface(1f);
        thorax.uvs = null;
        string body = Write(thorax, null, new JsonObject { ["mesh"] = 0 }, tint: Numbers(0.5f, 0.2f, 0f, 1f));
        Assert.That(m_Run.Run("insect", "new", m_Run.Out, "--wing", wing, "--length", "4cm", "--mass", "500mg", "--frequency", "12Hz",
            "--body", body), Is.Zero, m_Run.Errors);

        Assert.That(Directory.GetFiles(m_Run.Out).Select(Path.GetFileName), Is.EquivalentTo(new[]
        {
            "out.insect.json", "wing.obj", "wing.png", "wing.json", "wing.svg", "body.obj",
        }));
        Assert.That(File.ReadAllBytes(Path.Combine(m_Run.Out, "wing.png")), Is.EqualTo(png));
        ObjMesh written = ObjReader.Read(new StreamReader(Path.Combine(m_Run.Out, "body.obj")));

        // Light of a half and a fifth, encoded.
        Assert.That(written.Colours.Distinct(), Is.EqualTo(new[] { new Color32(188, 124, 0, 255) }));
        var file = JsonNode.Parse(File.ReadAllText(Path.Combine(m_Run.Out, "out.insect.json")));
        Assert.That((double)file["body"]["meshUnitMillimetres"], Is.EqualTo(1000), "glTF counts metres");
        string flight = Path.Combine(m_Run.Folder, "flight");
        Assert.That(
            m_Run.Run("fly", Path.Combine(m_Run.Out, "out.insect.json"), "--no-pictures", "--out", flight), Is.Zero, m_Run.Errors);
        var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(flight, "summary.json")));
        Assert.That((double)summary["edge_stretch_max_pct"], Is.InRange(0.1, 10));
    }

    // Without texture coordinates a picture has no place.
    [Test]
    public void WithoutTextureCoordinates_ThePictureIsLeftOut()
    {
        SurfaceMesh wing = Wing();
        wing.uvs = null;
        byte[] png = TrueColourPng.Write(32, 32, new Color32[32 * 32], []);
        Assert.That(New(Write(wing, png, new JsonObject { ["mesh"] = 0 })), Is.Zero, m_Run.Errors);
        Assert.That(Path.Combine(m_Run.Out, "wing.png"), Does.Not.Exist);
        Assert.That(File.ReadAllText(Path.Combine(m_Run.Out, "wing.obj")), Does.Not.Contain("vt "));
    }

    [Test]
    public void WhatIsNoGlb_OrHasNoTriangles_IsOneLine()
    {
        Assert.That(New(m_Run.Write("text.glb", "v 0 0 0\n")), Is.EqualTo(2));
        Assert.That(m_Run.Errors.Trim(), Does.StartWith("alate: ").And.Contain("text.glb is no GLB file that can be read: ")
            .And.Not.Contain("\n"));
        Assert.That(New(Write(Wing(), null, new JsonObject { ["name"] = "nothing" })), Is.EqualTo(2));
        Assert.That(m_Run.Errors, Does.Contain("mesh.glb: the file has no triangles."));
        Assert.That(Directory.Exists(m_Run.Out), Is.False);
    }

    [Test]
    public void DamagedFiles_AreReadOrRefusedInOneLine([Values(1, 2, 3)] int seed)
    {
        byte[] whole = File.ReadAllBytes(Write(Wing(), null, new JsonObject { ["mesh"] = 0 }));
        var random = new System.Random(seed);
        int refused = 0;
        for (int run = 0; run < 40; run++)
        {
            byte[] damaged = [.. whole.Take(run % 4 == 0 ? random.Next(whole.Length) : whole.Length)];
            for (int k = 0; k < 3 && damaged.Length > 0; k++)
                damaged[random.Next(Math.Min(damaged.Length, 900))] = (byte)random.Next(256);
            string file = Path.Combine(m_Run.Folder, "damaged.glb");
            File.WriteAllBytes(file, damaged);
            try
            {
                GlbMesh.Read(file);
            }
            catch (UserException problem)
            {
                Assert.That(problem.Message, Does.Contain("damaged.glb").And.Not.Contain("\n"));
                refused++;
            }
        }

        Assert.That(refused, Is.InRange(10, 40));
    }

    private int New(string wing) =>
        m_Run.Run("insect", "new", m_Run.Out, "--wing", wing, "--length", "4cm", "--mass", "500mg", "--frequency", "12Hz");

    private static SurfaceMesh Wing()
    {
        SurfaceMesh wing = InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right);
        wing.uvs = Array.ConvertAll(wing.positions, place => new Vector2(0.5f * place.x, place.z));
        return wing;
    }

    private static float3 Gltf(float3 place) => new(-place.x, place.y, place.z);

    private static JsonArray Numbers(params float[] numbers) => new(Array.ConvertAll(numbers, number => (JsonNode)(double)number));

    // A file with one mesh: a buffer with positions, indices, texture coordinates and a picture, and nodes, of which the last is the root.
    private string Write(SurfaceMesh mesh, byte[] png, JsonObject node, JsonObject root = null, JsonArray tint = null)
    {
        var binary = new MemoryStream();
        var views = new JsonArray();
        int View(byte[] content)
        {
            binary.Write(new byte[(int)(-binary.Length & 3)]);
            views.Add(new JsonObject { ["buffer"] = 0, ["byteOffset"] = binary.Length, ["byteLength"] = content.Length });
            binary.Write(content);
            return views.Count - 1;
        }

        float3[] places = Array.ConvertAll(mesh.positions, place => Gltf(place));
        int[] turned = [.. Enumerable.Range(0, mesh.triangles.Length)
            .Select(k => mesh.triangles[k % 3 == 0 ? k : k % 3 == 1 ? k + 1 : k - 1])];
        var accessors = new JsonArray
        {
            Accessor(View(MemoryMarshal.AsBytes<float3>(places).ToArray()), 5126, places.Length, "VEC3"),
            Accessor(View(MemoryMarshal.AsBytes<int>(turned).ToArray()), 5125, turned.Length, "SCALAR"),
        };
        float3 low = places.Aggregate(math.min), high = places.Aggregate(math.max);
        accessors[0]["min"] = Numbers(low.x, low.y, low.z);
        accessors[0]["max"] = Numbers(high.x, high.y, high.z);
        var attributes = new JsonObject { ["POSITION"] = 0 };
        if (mesh.uvs != null)
        {
            Vector2[] down = Array.ConvertAll(mesh.uvs, uv => new Vector2(uv.x, 1f - uv.y));
            accessors.Add(Accessor(View(MemoryMarshal.AsBytes<Vector2>(down).ToArray()), 5126, down.Length, "VEC2"));
            attributes["TEXCOORD_0"] = 2;
        }

        var paint = new JsonObject { ["baseColorFactor"] = tint ?? Numbers(1f, 1f, 1f, 1f) };
        var gltf = new JsonObject { ["asset"] = new JsonObject { ["version"] = "2.0" } };
        if (png != null)
        {
            gltf["images"] = new JsonArray(new JsonObject { ["mimeType"] = "image/png", ["bufferView"] = View(png) });
            gltf["textures"] = new JsonArray(new JsonObject { ["source"] = 0 });
            paint["baseColorTexture"] = new JsonObject { ["index"] = 0 };
        }

        gltf["materials"] = new JsonArray(new JsonObject { ["pbrMetallicRoughness"] = paint });
        gltf["bufferViews"] = views;
        gltf["accessors"] = accessors;
        gltf["meshes"] = new JsonArray(new JsonObject
        {
            ["primitives"] = new JsonArray(new JsonObject { ["attributes"] = attributes, ["indices"] = 1, ["material"] = 0 }),
        });
        gltf["nodes"] = root == null ? new JsonArray(node) : new JsonArray(node, root);
        gltf["scenes"] = new JsonArray(new JsonObject { ["nodes"] = new JsonArray(root == null ? 0 : 1) });
        gltf["scene"] = 0;
        gltf["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = binary.Length });
        string path = Path.Combine(m_Run.Folder, png == null && tint != null ? "body.glb" : "mesh.glb");
        using FileStream stream = File.Create(path);
        GlbWriter.Write(gltf, binary.ToArray(), stream);
        return path;
    }

    private static JsonObject Accessor(int view, int component, int count, string type) =>
        new() { ["bufferView"] = view, ["componentType"] = component, ["count"] = count, ["type"] = type };
}
