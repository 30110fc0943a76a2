using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of the paler lower sides of wings: in materials, in photos, and on both sides of an insect.</summary>
public sealed class UndersideLaws
{
    private static readonly string[] s_Pale = ["monarch", "swallowtail", "painted-lichen-moth"];

    [SetUp]
    public void AddTheShader() => ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");

    [TearDown]
    public void TakeTheShader() => ProjectShaders.Clear();

    [Test]
    public void Materials_HaveThatOfTheirPattern()
    {
        foreach (InsectDefinition insect in InsectCatalogue.All)
        {
            foreach (WingDefinition wing in insect.Wings.Where(wing => wing.Pattern != null))
            {
                Material material = WingMaterial.ForWing(wing, 32);
                Assert.That(material.GetColor("_Underside"), Is.EqualTo(wing.Pattern.Underside), insect.Name);
                Assert.That(wing.Pattern.Underside.a > 0f, Is.EqualTo(s_Pale.Contains(insect.Name)), insect.Name);
                WingMaterial.Destroy(material);
            }
        }

        Material own = WingMaterial.ForVertexColours(true, false);
        Assert.That(own.GetColor("_Underside").a, Is.Zero, "without a pattern");
        WingMaterial.Destroy(own);
    }

    // A camera above sees the upper side of both wings where they are level, and one below the lower one.
    [Test]
    public void NormalsOfBothWings_AreThoseOfTheUpperSide()
    {
        FlightRecord flight = MonarchFlight.Level;
        foreach (double turns in new[] { 0.3, 0.35, 0.75 })
        {
            float3[] mean = [.. flight.Wings.Select(wing => math.normalize(wing.At(turns).Normals.Aggregate((a, b) => a + b)))];
            Assert.That(mean.Select(normal => normal.y), Is.All.GreaterThan(0.3f), $"{turns}");
            Assert.That(math.distance(mean[0] * new float3(-1f, 1f, 1f), mean[1]), Is.LessThan(1e-3f), "one mirrors the other");
        }
    }

    [Test]
    public void APhoto_ShowsIt_FromBelowAlone([Values] bool isBelow)
    {
        var camera = new PictureCamera(PictureView.ByName["top"], 5f);
        var shading = new Shading(camera);
        float3 orange = new(0.8f, 0.25f, 0.02f), normal = isBelow ? -camera.Towards : camera.Towards;
        var pale = new float4(0.9f, 0.7f, 0.4f, 0.5f);

        float3 seen = shading.Light(orange, normal, true, 1f, 1f, pale);

        float3 expected = isBelow ? math.lerp(orange, pale.xyz, 0.5f * 0.8f) : orange;
        Assert.That(math.distance(seen, shading.Light(expected, normal, true)), Is.LessThan(1e-6f));
        Assert.That(shading.Light(orange, normal, false, 1f, 1f, pale), Is.EqualTo(shading.Light(orange, normal, false)), "a body");
    }
}
