using System.Collections;
using System.Linq;
using Alate.Catalogue;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

/// <summary>The swarm with parts that have the package's own shader.</summary>
public sealed class SwarmOnTheCardTests : SampleFixture<SwarmSample>
{
    [OneTimeSetUp]
    public void AddTheShader() => ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");

    [OneTimeTearDown]
    public void TakeTheShader() => ProjectShaders.Clear();

    [UnityTest]
    public IEnumerator WingsOnTheGraphicsCard_AreTintedAsInstances_AndWithoutItAsRenderers()
    {
        yield return Begin();
        DrawnScreen.Slide("Insects", 12f);
        yield return Frames(10);
        var tint = new MaterialPropertyBlock();
        Renderer wing = Insects.First().Wings[0].Renderer;
        wing.GetPropertyBlock(tint);
        Assert.That(tint.GetColor("_SkinTint"), Is.Not.EqualTo(default(Color)).And.Not.EqualTo(Color.white));
        Assert.That(tint.GetColor("_Color"), Is.EqualTo(default(Color)));

        DrawnScreen.Press("Deformed by the graphics card");
        yield return Frames(6);
        wing.GetPropertyBlock(tint);
        Assert.That(tint.GetColor("_Color"), Is.Not.EqualTo(default(Color)));
        Assert.That(wing.sharedMaterial.IsKeywordEnabled("_SKINNED"), Is.False);
    }

    protected override void Shrink() => DrawnScreen.Slide("Insects", 12f);
}
