using System;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Play.Headless;

/// <summary>Insects of a material whose shader can deform wings.</summary>
public abstract class GpuFixture : FlockFixture
{
    /// <summary>Material of all wings.</summary>
    protected Material Membrane { get; private set; }

    [SetUp]
    public void MakeAMaterial()
    {
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
        Membrane = Keep(new Material(Shader.Find(WingMaterial.ShaderName)) { name = "membrane" });
    }

    [TearDown]
    public void UseTheUsualDevice()
    {
        PlainDevice.IsInUse = false;
        PlainDevice.LargestTexture = 16384;
        ProjectShaders.Clear();
    }

    /// <summary>An insect that begins to live, deformed by what is told.</summary>
    protected InsectWings Hatched(WingSkinning skinning, Action<InsectWings> prepare = null) => Hatch(made =>
    {
        made.Quality.skinning = skinning;
        foreach (Wing wing in made.Wings)
            wing.Renderer.sharedMaterial = Membrane;
        prepare?.Invoke(made);
    });
}
