using System.Collections;
using System.Linq;
using Alate.Samples;
using Alate.Showcase;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class MonarchSampleTests : SampleFixture<MonarchSample>
{
    [UnityTest]
    public IEnumerator TheMonarch_FliesAtTheSpeedOfTheSlider()
    {
        yield return Begin();
        yield return Frames(60);

        // 11 / (1 + exp(-16 (1.3 / 2 - 0.5))), Eq. 6 at 1.3 of 2 m/s.
        Assert.That(Insects.Single().Frequency, Is.EqualTo(10.085f).Within(0.05f));
    }

    [UnityTest]
    public IEnumerator DraggingTheMouse_TurnsTheCamera_AndTheWheelMovesIt()
    {
        yield return Begin();
        OrbitCamera orbit = Sample.GetComponentInChildren<OrbitCamera>();
        float yaw = orbit.Yaw, distance = orbit.Distance;
        DrawnScreen.Drag(new Vector2(20f, 0f));
        DrawnScreen.Scroll(1f);
        yield return Frames(6);
        Assert.That(orbit.Yaw, Is.GreaterThan(yaw));
        Assert.That(orbit.Distance, Is.LessThan(distance));
    }
}
