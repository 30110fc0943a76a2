using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>Wings that the graphics card deforms, in pictures of scenes.</summary>
public sealed class GpuPictureTests : FlockFixture
{
    private Material m_Material;

    [SetUp]
    public void MakeAMaterial()
    {
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
        m_Material = Keep(new Material(Shader.Find(WingMaterial.ShaderName)) { name = "membrane" });
    }

    [TearDown]
    public void TakeTheShader() => ProjectShaders.Clear();

    [UnityTest]
    public IEnumerator TheyAre_WhereTheProcessorPutsThem()
    {
        InsectWings cpu = Hatched(WingSkinning.Cpu), gpu = Hatched(WingSkinning.Gpu);
        Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
        yield return Frames(12);

        Assert.That(gpu.SkinningObstacle, Is.Empty);
        IReadOnlyList<SceneSurface> shown = new SceneReader().Shot(camera, new int2(8, 8)).Surfaces;
        Assert.That(shown, Has.Count.EqualTo(cpu.Wings.Count + gpu.Wings.Count));
        for (int wing = 0; wing < cpu.Wings.Count; wing++)
        {
            SceneSurface wanted = shown[wing], found = shown[wing + cpu.Wings.Count];
            Assert.That(found.Places.Zip(wanted.Places, math.distance).Max(), Is.InRange(0f, 1e-5f));
            Assert.That(found.Normals.Zip(wanted.Normals, math.distance).Max(), Is.InRange(0f, 0.01f), "of signed bytes");
            Assert.That(found.Places.Max(place => math.abs(place.y)), Is.GreaterThan(0.01f), "the wing lies flat");
        }
    }

    // As the script of a swarm tints them.
    [UnityTest]
    public IEnumerator ATintOfARenderer_IsThatOfItsPicture([Values(WingSkinning.Cpu, WingSkinning.Gpu)] WingSkinning skinning)
    {
        InsectWings insect = Hatched(skinning);
        Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
        yield return Frames(3);
        var tint = new MaterialPropertyBlock();
        insect.Wings[0].Renderer.GetPropertyBlock(tint);
        tint.SetColor(skinning == WingSkinning.Gpu ? "_SkinTint" : "_Color", new Color(1f, 0.5f, 0f));
        insect.Wings[0].Renderer.SetPropertyBlock(tint);
        yield return Frames(3);

        SceneSurface[] shown = [.. new SceneReader().Shot(camera, new int2(8, 8)).Surfaces];
        Assert.That(shown[0].Look.Tint.y, Is.EqualTo(Shading.ToLinear(0.5f).x).Within(1e-5f));
        Assert.That(shown[0].Look.Tint.z, Is.Zero.Within(1e-6f));
        Assert.That(shown[1].Look.Tint, Is.EqualTo((float4)1f));
    }

    private InsectWings Hatched(WingSkinning skinning) => Hatch(insect =>
    {
        insect.Quality.skinning = skinning;
        // Smaller meshes for the distance would change the order of the vertices.
        insect.Quality.levelOfDetail = false;
        foreach (Wing wing in insect.Wings)
            wing.Renderer.sharedMaterial = m_Material;
    });
}
