using System.Collections;
using System.Linq;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class OwnWingSampleTests : SampleFixture<OwnWingSample>
{
    [UnityTest]
    public IEnumerator EveryStep_CanBeWalkedTo_ForwardsAndBackwards()
    {
        yield return Begin();
        for (int step = 4; step >= 0; step--)
        {
            yield return Frames(4);
            Assert.That(DrawnScreen.Text, Does.StartWith($"{step + 1}."));
            Assert.That(Insects.Count(insect => insect.State == InsectState.Ready), Is.EqualTo(step >= 3 ? 1 : 0));
            DrawnScreen.Press("Back");
            yield return Frames(4);
        }

        for (int step = 0; step < 4; step++)
        {
            DrawnScreen.Press("Next");
            yield return Frames(4);
        }

        Assert.That(DrawnScreen.Text, Does.StartWith("5."));
        Assert.That(Insects.Single().State, Is.EqualTo(InsectState.Ready));
    }

    [UnityTest]
    public IEnumerator BothWingsAreFound_AndTheirSkeletonsLieOnThem()
    {
        yield return Begin();
        InsectWings insect = Insects.Single();
        Assert.That(insect.Wings.Select(wing => wing.Side), Is.EquivalentTo(new[] { WingSide.Right, WingSide.Left }));
        foreach (Wing wing in insect.Wings)
        {
            Assert.That(wing.Part, Is.EqualTo(WingPart.ConnectedPart));
            float side = wing.Side == WingSide.Right ? 1f : -1f;
            for (int joint = 0; joint < wing.Skeleton.JointsPerChain; joint++)
            {
                Vector3 leading = wing.Skeleton.GetJoint(0, joint);
                Assert.That(side * leading.x, Is.InRange(0.069f, 1.071f));
                Assert.That(leading.z, Is.InRange(0f, 0.201f), "the leading edge is not the front one");
            }

            Assert.That(wing.Skeleton.GetJoint(0, 4).z, Is.GreaterThan(wing.Skeleton.GetJoint(4, 4).z));
        }
    }

    [UnityTest]
    public IEnumerator TheBody_StaysStill()
    {
        yield return Begin();
        MeshFilter filter = Insects.Single().GetComponent<MeshFilter>();
        Vector3[] before = filter.sharedMesh.vertices;
        Color32[] colours = filter.sharedMesh.colors32;
        yield return Frames(20);
        Vector3[] after = filter.sharedMesh.vertices;
        for (int k = 0; k < before.Length; k++)
        {
            if (colours[k].b < 100)
                Assert.That(after[k], Is.EqualTo(before[k]));
        }

        Assert.That(after.Where((vertex, k) => (vertex - before[k]).magnitude > 0.05f).Count(), Is.GreaterThan(100));
    }

    [UnityTest]
    public IEnumerator TheSliders_TuneTheWings()
    {
        yield return Begin();
        DrawnScreen.Slide("Frequency", 40f);
        DrawnScreen.Slide("Time", 1f);
        yield return Frames(30);
        Assert.That(Insects.Single().Frequency, Is.EqualTo(0.8f * 40f).Within(0.5f), "hovering beats at 0.8 of the full frequency");
    }
}
