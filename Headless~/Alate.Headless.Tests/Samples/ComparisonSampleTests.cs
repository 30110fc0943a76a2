using System.Collections;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class ComparisonSampleTests : SampleFixture<ComparisonSample>
{
    [TearDown]
    public void DeleteVotes()
    {
        if (Directory.Exists(Application.persistentDataPath))
            Directory.Delete(Application.persistentDataPath, true);
    }

    [UnityTest]
    public IEnumerator FourColumns_BeatInStep_AndBendTheMoreTheSofterTheyAre()
    {
        yield return Begin();
        yield return Frames(2);
        foreach (ComparisonColumn column in ComparisonColumn.All)
            Assert.That(DrawnScreen.Text, Does.Contain(column.Title));
        InsectWings[] insects = [.. ComparisonColumn.All.Select(column => Insects.Single(insect => insect.name == column.Title))];
        float[] bends = new float[4];
        for (int frame = 0; frame < 60; frame++)
        {
            yield return null;
            for (int k = 0; k < 4; k++)
            {
                Assert.That(insects[k].Phase, Is.EqualTo(insects[0].Phase).Within(0.1f));
                bends[k] = Mathf.Max(bends[k], BendOf(insects[k]));
            }
        }

        Assert.That(bends[0], Is.LessThan(1e-4f), "the rigid wing bends");
        Assert.That(bends[2], Is.GreaterThan(0.01f));
        Assert.That(bends[3], Is.GreaterThan(1.05f * bends[2]), "the soft wing bends no more than the full model's");
    }

    [UnityTest]
    public IEnumerator TheSliders_TuneAllColumns_AndKeepWhatTheyLeaveOut()
    {
        yield return Begin();
        DrawnScreen.Slide("Frequency", 2f);
        DrawnScreen.Slide("Delay", 3f);
        DrawnScreen.Slide("Elasticity", 2f);
        DrawnScreen.Slide("Head wind", 2f);
        yield return Frames(12);
        WingPreset usual = Keep(InsectCatalogue.All[0].Wings[0].CreatePreset());
        foreach (InsectWings insect in Insects)
        {
            Assert.That(insect.Preset.Beat.maxFrequency, Is.EqualTo(2f * usual.Beat.maxFrequency));
            float delay = insect.name is "Rigid wing" or "No deformation wave" ? 0f : 3f * usual.Wave.chordDelay;
            Assert.That(insect.Preset.Wave.chordDelay, Is.EqualTo(delay).Within(1e-5f), insect.name);
            Assert.That(Vector3.Dot(insect.Air.wind, insect.transform.forward), Is.LessThan(0f));
        }

        float soft = Insects.Single(insect => insect.name.StartsWith("Elasticity")).Preset.Stiffness.elasticity;
        Assert.That(soft, Is.EqualTo(2f * ComparisonColumn.OtherElasticity * usual.Stiffness.elasticity).Within(1e-5f));
    }

    [UnityTest]
    public IEnumerator Keys_ShowOneColumnAlone_AndAllAgain([Values(1, 4)] int number)
    {
        yield return Begin();
        DrawnScreen.Key(KeyCode.Alpha0 + number);
        yield return Frames(4);
        InsectWings[] shown = [.. Insects.Where(insect => insect.Wings[0].Renderer.enabled)];
        Assert.That(shown.Select(insect => insect.name), Is.EqualTo(new[] { ComparisonColumn.All[number - 1].Title }));
        Assert.That(shown[0].transform.localPosition, Is.EqualTo(Vector3.zero));
        Assert.That(DrawnScreen.Text, Does.Contain(ComparisonColumn.All[number - 1].Title).And.Not.Contain("No deformation wave"));

        DrawnScreen.Key(KeyCode.Alpha0);
        yield return Frames(4);
        Assert.That(Insects.Count(insect => insect.Wings[0].Renderer.enabled), Is.EqualTo(4));
    }

    [UnityTest]
    public IEnumerator AnotherSpecies_TakesThePlaceOfTheFirst()
    {
        yield return Begin();
        DrawnScreen.Press("<");
        yield return Frames(5);
        Assert.That(Insects.Count(), Is.EqualTo(4));
        Assert.That(Insects.Select(insect => insect.State), Is.All.EqualTo(InsectState.Ready));
        Assert.That(Insects.First().Preset.WingLength, Is.EqualTo((float)InsectCatalogue.All[^1].Wings[0].Outline.Length).Within(1e-6f),
            "the last species comes before the first");
    }

    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator TheStudy_AsksTwelveTimes_WithoutNames_WritesTheVotesDown_AndCountsThem()
    {
        yield return Begin();
        DrawnScreen.Press("Begin study");
        yield return Frames(4);
        for (int pair = 1; pair <= 12; pair++)
        {
            Assert.That(DrawnScreen.Text, Does.Contain($"Pair {pair} of 12"));
            foreach (ComparisonColumn column in ComparisonColumn.All)
                Assert.That(DrawnScreen.Text, Does.Not.Contain(column.Title), "the study is not blind");
            Assert.That(Insects.Count(), Is.EqualTo(2));
            bool fullIsLeft = LeftOf(Insects.ToArray()) == "Full model";
            DrawnScreen.Press(fullIsLeft ? "Left" : "Right");
            yield return Frames(5);
        }

        string[] lines = File.ReadAllLines(Path.Combine(Application.persistentDataPath, "Alate comparison votes.csv"));
        Assert.That(lines, Has.Length.EqualTo(13));
        Assert.That(lines.Skip(1).Where(line => line.Contains(",full")).All(line => line.EndsWith(",full")), Is.True,
            "the votes are not those that were given");
        Assert.That(
            DrawnScreen.Text, Does.Contain("Full model 4 : 0 Rigid wing, p < 0.001").And.Contain("Full model 4 : 0 No deformation wave"));

        DrawnScreen.Press("Leave study");
        yield return Frames(4);
        Assert.That(Insects.Count(), Is.EqualTo(4));
        Assert.That(DrawnScreen.Text, Does.Contain("Elasticity × 1.00"));
    }

    // Of two insects the one on the left of the picture.
    private static string LeftOf(InsectWings[] insects) =>
        insects.OrderBy(insect => Camera.main.WorldToScreenPoint(insect.transform.position).x).First().name;

    // How far the tip of the trailing chains is from where the leading chain and the root carry it as a rigid plate.
    private static float BendOf(InsectWings insect)
    {
        WingSkeleton skeleton = insect.Wings[0].Skeleton;
        int last = skeleton.ChainCount - 1, end = skeleton.JointsPerChain - 1;
        Vector3 root = insect.JointPosition(0, 0, 0), rear = insect.JointPosition(0, last, 0), tip = insect.JointPosition(0, 0, end);
        Vector3 normal = Vector3.Cross(tip - root, rear - root).normalized;
        return Mathf.Abs(Vector3.Dot(insect.JointPosition(0, last, end) - root, normal));
    }
}
