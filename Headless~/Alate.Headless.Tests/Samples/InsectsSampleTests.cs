using System.Collections;
using System.Linq;
using Alate.Catalogue;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class InsectsSampleTests : SampleFixture<InsectsSample>
{
    [UnityTest]
    public IEnumerator AllSpecies_AreInThePicture_WithTheirNames()
    {
        yield return Begin();
        yield return Frames(2);
        Assert.That(Insects.Count(), Is.EqualTo(InsectCatalogue.All.Count));
        foreach (InsectDefinition species in InsectCatalogue.All)
            Assert.That(DrawnScreen.Text, Does.Contain(species.DisplayName));
        foreach (InsectWings insect in Insects)
        {
            Vector3 seen = Camera.main.WorldToViewportPoint(insect.transform.position);
            Assert.That(seen.x, Is.InRange(0.05f, 0.95f), insect.name);
            Assert.That(seen.y, Is.InRange(0.05f, 0.95f), insect.name);
        }
    }

    [UnityTest]
    public IEnumerator Variants_AreToggled_WhereASpeciesHasThem()
    {
        yield return Begin();
        DrawnScreen.Press("Biological");
        yield return Frames(4);
        Assert.That(Insects.Single(insect => insect.name == "Firefly").Preset.Beat.maxFrequency, Is.EqualTo(62f));
        Assert.That(DrawnScreen.Text, Does.Contain("Monarch\nStandard"));
        Assert.That(Insects.Count(), Is.EqualTo(InsectCatalogue.All.Count));

        DrawnScreen.Press("Standard");
        yield return Frames(4);
        Assert.That(Insects.Single(insect => insect.name == "Firefly").Preset.Beat.maxFrequency, Is.EqualTo(11f));
    }

    [UnityTest]
    public IEnumerator SlowMotion_SlowsTheBeat()
    {
        yield return Begin();
        InsectWings monarch = Insects.Single(insect => insect.name == "Monarch");
        foreach (float timeScale in new[] { 0.1f, 0.01f })
        {
            DrawnScreen.Slide("Time", Mathf.Log10(timeScale));
            yield return Frames(3);
            float before = monarch.Phase, frequency = monarch.Frequency;
            yield return Frames(6);
            float degrees = Mathf.Repeat(monarch.Phase - before, 360f);
            Assert.That(degrees, Is.EqualTo(360f * frequency * timeScale * 6f / 60f).Within(5).Percent);
        }
    }
}
