using System.Collections;
using System.Linq;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class SwarmSampleTests : SampleFixture<SwarmSample>
{
    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator HundredsFly_AtSeveralLevelsOfDetail_WhichThePanelCounts()
    {
        yield return Begin();
        for (int frame = 0; frame < 120 && WingSystem.InsectCount < 300; frame++)
            yield return null;
        Assert.That(WingSystem.InsectCount, Is.EqualTo(300));
        yield return Frames(30);

        foreach (WingDetail detail in new[] { WingDetail.FewerSubsteps, WingDetail.CoarsePatches, WingDetail.WavesOnly })
        {
            int shown = Insects.Count(insect => insect.Detail == detail);
            Assert.That(shown, Is.GreaterThan(0), $"no insect is at {detail}");
            int counted = int.Parse(DrawnScreen.Controls.Single(control => control.Text.EndsWith(" " + detail)).Text.Split(' ')[0]);
            Assert.That(counted, Is.EqualTo(shown).Within(15));
        }
    }

    [UnityTest]
    public IEnumerator TheColourOfItsWings_IsThatOfItsDetail()
    {
        yield return Begin();
        DrawnScreen.Slide("Insects", 40f);
        yield return Frames(30);
        var tint = new MaterialPropertyBlock();
        foreach (IGrouping<WingDetail, InsectWings> alike in Insects.GroupBy(insect => insect.Detail))
        {
            Color[] colours = alike.SelectMany(insect => insect.Wings).Select(wing =>
            {
                wing.Renderer.GetPropertyBlock(tint);
                return tint.GetColor("_Color");
            }).ToArray();
            Assert.That(colours.GroupBy(colour => colour).Max(group => group.Count()), Is.GreaterThan(0.8 * colours.Length),
                "the colours do not say the detail");
        }
    }

    [UnityTest]
    public IEnumerator TheSlider_MakesAndEndsInsects([Values(5, 60)] int count)
    {
        yield return Begin();
        DrawnScreen.Slide("Insects", count);
        yield return Frames(40);
        Assert.That(Insects.Count(), Is.EqualTo(count));
        Assert.That(WingSystem.InsectCount, Is.EqualTo(count));
    }

    [UnityTest]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public IEnumerator InsectsFlyWhereTheirHeadsPoint()
    {
        yield return Begin();
        DrawnScreen.Slide("Insects", 12f);
        yield return Frames(10);
        InsectWings[] insects = [.. Insects];
        Vector3[] before = [.. insects.Select(insect => insect.transform.position)];
        yield return null;
        for (int k = 0; k < insects.Length; k++)
        {
            Vector3 way = insects[k].transform.position - before[k];
            Assert.That(Vector3.Angle(way, insects[k].transform.forward), Is.LessThan(45f));
        }
    }

    [UnityTest]
    public IEnumerator WithoutLevelsOfDetail_AllThatAreSeen_AreComputedInFull()
    {
        yield return Begin();
        DrawnScreen.Slide("Insects", 20f);
        DrawnScreen.Press("Level of detail");
        yield return Frames(20);
        InsectWings[] seen = [.. Insects.Where(insect => insect.Wings.Exists(wing => wing.Renderer.isVisible))];
        Assert.That(seen, Is.Not.Empty);
        Assert.That(seen.Select(insect => insect.Detail), Is.All.EqualTo(WingDetail.Full));
    }

    [UnityTest]
    public IEnumerator TheBudget_IsThatOfTheSlider_AndEndsWithTheSample()
    {
        yield return Begin();
        DrawnScreen.Slide("Insects", 12f);
        yield return Frames(6);
        DrawnScreen.Slide("Budget", 3f);
        yield return Frames(6);
        Assert.That(WingSystem.Budget, Is.EqualTo(3f));
        Assert.That(DrawnScreen.Controls.Any(control => control.Text == "Budget: 3.0 ms"));
        Assert.That(WingSystem.MeanTime, Is.GreaterThan(0f));
        Object.Destroy(Sample.gameObject);
        yield return null;
        Assert.That(WingSystem.Budget, Is.Zero);
    }

    protected override void Shrink() => DrawnScreen.Slide("Insects", 40f);
}
