using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>Many insects that the graphics card deforms: how they start, how they are drawn, and what is lost of them.</summary>
public sealed class GpuSwarmTests : GpuFixture
{
    [UnityTest]
    public IEnumerator AFrame_StartsFourTimesAsMany_AsTheProcessorWould_AndTheTextureIsMadeOnce()
    {
        int counted = WingMesh.vertexCount / 4 * 2, each = (10240 + counted - 1) / counted;
        Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        int joints = WingSystem.Loop.Skins.Table.Joints;
        for (int k = 0; k < each + 200; k++)
            Hatched(WingSkinning.Gpu);
        yield return null;
        Assert.That(WingSystem.InsectCount, Is.EqualTo(1 + each));
        int version = WingSystem.Loop.Skins.Table.Version;
        while (WingSystem.InsectCount < each + 201)
            yield return null;
        Assert.That(WingSystem.Loop.Skins.Table.Version, Is.EqualTo(version), "room for all who wait was made at first");
        Assert.That(WingSystem.Loop.Skins.Table.Joints, Is.EqualTo((each + 201) * joints));
    }

    // 64 KB of constants hold 511 instances of two matrices and what the shader adds.
    [UnityTest]
    public IEnumerator AThousandInsectsOfThreeKinds_AreTwelveDrawCallsOrFewer()
    {
        var renderers = new List<Renderer>();
        foreach (string kind in new[] { "monarch", "swallowtail", "dragonfly" })
        {
            for (int k = 0; k < 3; k++)
            {
                InsectWings insect = InsectFactory.Create(InsectCatalogue.Find(kind), InsectVariant.Standard);
                Keep(insect.gameObject);
                insect.Quality.skinning = WingSkinning.Gpu;
                insect.Quality.culling = WingCulling.AlwaysSimulate;
                renderers.AddRange(insect.Wings.Select(wing => wing.Renderer));
            }
        }

        yield return Frames(5);
        Assert.That(renderers.Count, Is.EqualTo(3 * (2 + 4 + 4)));
        Assert.That(renderers.All(renderer => renderer.sharedMaterial.enableInstancing), Is.True);
        int draws = renderers.GroupBy(renderer => (renderer.GetComponent<MeshFilter>().sharedMesh, renderer.sharedMaterial))
            .Sum(group => (group.Count() * 1000 / 9 + 510) / 511);
        Assert.That(draws, Is.LessThanOrEqualTo(12));
    }

    // A frame looks at 64 insects: the one whose wing is gone is drawn for some frames before it is found.
    [UnityTest]
    public IEnumerator OfALargeCrowd_AWingThatIsDestroyed_HarmsNobody()
    {
        InsectWings[] swarm = [.. Enumerable.Range(0, 200).Select(_ => Hatched(WingSkinning.Gpu))];
        while (WingSystem.InsectCount < 200)
            yield return null;
        foreach (int k in new[] { 0, 70, 140, 199 })
            Object.Destroy(swarm[k].Wings[0].Renderer.gameObject);
        yield return Frames(1 + (200 + 63) / 64);

        Assert.That(swarm.Count(insect => insect.State == InsectState.NoRenderer), Is.EqualTo(4));
        Assert.That(WingSystem.InsectCount, Is.EqualTo(196));
        Assert.That(GpuSkinReader.Deformed(swarm[1].Wings[0].Renderer).Places.Length, Is.EqualTo(WingMesh.vertexCount));
    }
}
