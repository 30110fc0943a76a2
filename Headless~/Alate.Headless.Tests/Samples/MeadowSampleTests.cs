using System.Collections;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class MeadowSampleTests : PlayFixture
{
    [SetUp]
    public void AddTheShader() => ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");

    [TearDown]
    public void ForgetTheShader() => ProjectShaders.Clear();

    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator TenThousandFly_AHandfulOfThemLive_AndNothingIsLeft()
    {
        int before = Resources.FindObjectsOfTypeAll<Mesh>().Length + Resources.FindObjectsOfTypeAll<Texture2D>().Length
            + Resources.FindObjectsOfTypeAll<GameObject>().Length;
        MeadowSample sample = Keep(new GameObject("meadow")).AddComponent<MeadowSample>();
        yield return Frames(2);
        InsectCrowd[] crowds = sample.GetComponentsInChildren<InsectCrowd>();
        float3 place = crowds[0].Poses[17].position;
        yield return Frames(100);

        Assert.That(crowds.Sum(crowd => crowd.Count), Is.EqualTo(10000));
        Assert.That(crowds.Select(crowd => crowd.Problem), Is.All.Null);
        Assert.That(crowds.Sum(crowd => crowd.DrawnCount), Is.GreaterThan(1000));
        Assert.That(crowds.Sum(crowd => crowd.LiveNow), Is.InRange(1, 8));
        Assert.That(crowds[0].Poses[17].position, Is.Not.EqualTo(place));
        Assert.That(DrawnScreen.Controls.Any(control => control.Text.Contains("baked in sight")), Is.True);

        Object.Destroy(sample.gameObject);
        yield return Frames(3);
        int after = Resources.FindObjectsOfTypeAll<Mesh>().Length + Resources.FindObjectsOfTypeAll<Texture2D>().Length
            + Resources.FindObjectsOfTypeAll<GameObject>().Length;
        Assert.That(after, Is.EqualTo(before), "something was left behind");
    }
}
