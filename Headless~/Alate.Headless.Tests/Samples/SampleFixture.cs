using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

/// <summary>
/// A sample in an empty scene, as after opening its scene and pressing Play. Whatever it logs as an error fails its test.
/// </summary>
public abstract class SampleFixture<T> : PlayFixture where T : MonoBehaviour
{
    /// <summary>The sample's script, on an object of its own.</summary>
    protected T Sample { get; private set; }

    /// <inheritdoc/>
    protected override bool KeepsParts => true;

    protected IEnumerable<InsectWings> Insects => Sample.GetComponentsInChildren<InsectWings>();

    [UnityTest]
    public IEnumerator RunsAHundredFrames_WithBeatingWings_LeavesNothing_AndBeginsAgain()
    {
        GiveBackParts();
        yield return Frames(2);
        string[] before = Left();
        yield return Begin();
        Shrink();
        yield return Frames(60);
        InsectWings[] insects = [.. Insects];
        Assert.That(insects, Is.Not.Empty);
        foreach (InsectWings insect in insects)
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
        Dictionary<InsectWings, float> phases = insects.ToDictionary(insect => insect, insect => insect.Phase);
        yield return Frames(3);
        foreach (InsectWings insect in insects.Where(insect => insect.Detail != WingDetail.Frozen))
            Assert.That(insect.Phase, Is.Not.EqualTo(phases[insect]), $"the wings of {insect.name} are still");
        Assert.That(DrawnScreen.Controls, Is.Not.Null);
        Assert.That(Camera.main != null, Is.True, "there is no camera");
        Assert.That(WingSystem.ResetCount, Is.Zero);
        yield return Frames(40);

        Object.Destroy(Sample.gameObject);
        yield return Frames(2);
        Assert.That(Left(), Is.EqualTo(before), "something was left behind");
        Assert.That(WingSystem.InsectCount, Is.Zero);

        yield return Begin();
        Assert.That(Insects.All(insect => insect.State == InsectState.Ready), Is.True);
    }

    /// <summary>Leaves fewer insects of a sample of very many, for the test of a hundred frames.</summary>
    protected virtual void Shrink()
    {
    }

    /// <summary>Adds the script and waits until its insects live.</summary>
    protected IEnumerator Begin()
    {
        Sample = Keep(new GameObject(typeof(T).Name)).AddComponent<T>();
        for (int frame = 0; frame < 60 && (frame < 3 || Insects.Any(insect => insect.State == InsectState.Waiting)); frame++)
            yield return null;
    }

    // Kinds and names of what there is; the skin of the screen is made once, and the trims of the catalogue once for all insects.
    private static string[] Left() =>
        [.. Resources.FindObjectsOfTypeAll<Object>()
            .Where(made => made is Mesh or Material or Texture2D or GameObject or (ScriptableObject
                and not (GUISkin or FlightTrims { hideFlags: HideFlags.HideAndDontSave })))
            .Select(made => $"{made.GetType().Name} {made.name}").Order()];
}
