using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>A budget that every frame exceeds, in play: far insects come down to their waves and rise again without it.</summary>
public sealed class BudgetPlayTests : FlockFixture
{
    private const float k_None = 1e-6f;

    [TearDown]
    public void TakeTheBudget() => WingSystem.Budget = 0f;

    [UnityTest]
    public IEnumerator FarInsects_ComeDownToWaves_TheNearestDoesNot_AndAllRiseAgain()
    {
        Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
        WingSystem.DetailCameras.Add(camera);
        InsectWings near = At(2f), far = At(7f), always = At(7f);
        always.Quality.levelOfDetail = false;
        yield return Frames(10);
        Assert.That((near.Detail, far.Detail), Is.EqualTo((WingDetail.Full, WingDetail.Full)));

        WingSystem.Budget = k_None;
        yield return Frames(250);
        Assert.That(WingSystem.MeanTime, Is.GreaterThan(k_None));
        Assert.That(near.Detail, Is.EqualTo(WingDetail.Full));
        Assert.That(far.Detail, Is.EqualTo(WingDetail.WavesOnly));
        Assert.That(always.Detail, Is.EqualTo(WingDetail.Full), "it has no levels");

        WingSystem.Budget = 0f;
        yield return Frames(3);
        Assert.That(far.Detail, Is.EqualTo(WingDetail.Full));
    }

    private InsectWings At(float distance) => Hatch(made => made.transform.position = new Vector3(0f, 0f, distance));
}
