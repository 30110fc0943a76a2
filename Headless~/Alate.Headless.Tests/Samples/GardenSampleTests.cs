using System.Collections;
using System.Linq;
using Alate.Flight;
using Alate.Samples;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Samples;

public sealed class GardenSampleTests : SampleFixture<GardenSample>
{
    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator Butterflies_FlyLandAndSit_WithTheirWingsFolded_AndFleeFromTheCamera()
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 4f);
        yield return Frames(30);
        InsectFlight sitting = null;
        for (int frame = 0; frame < 3000 && sitting == null; frame++)
        {
            foreach (InsectFlight flight in Sample.GetComponentsInChildren<InsectFlight>())
            {
                Assert.That(flight.Problem, Is.EqualTo(FlightProblem.None), flight.name);
                Assert.That(float.IsFinite(flight.Position.sqrMagnitude), Is.True);
                if (flight.State == FlightState.Perched && flight.GetComponent<PerchPilot>().Fold > 0.9f)
                    sitting = flight;
            }

            yield return null;
        }

        Assert.That(sitting != null, Is.True, "no butterfly sat within 50 s");
        Camera camera = Sample.GetComponentInChildren<Camera>();
        camera.GetComponent<MonoBehaviour>().enabled = false;
        camera.transform.position = sitting.Position + new Vector3(0f, 2f, -4f);
        yield return Frames(60);
        Assert.That(sitting.State, Is.EqualTo(FlightState.Flying), "a second after the camera came near");
        yield return Frames(120);

        // Beyond the distance at which it takes fright; from there on it flies where it likes.
        Assert.That(Vector3.Distance(sitting.Position, camera.transform.position), Is.GreaterThan(6f));
    }

    [UnityTest]
    public IEnumerator TheSnailfish_SwimsAroundTheGarden_ByItsOwnFins() => Swim(5);

    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator TheSnailfish_SwimsForAMinute() => Swim(60);

    [UnityTest]
    public IEnumerator TheSlider_MakesAndEndsButterflies([Values(0, 5)] int count)
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", count);
        yield return Frames(20);
        Assert.That(Sample.GetComponentsInChildren<PerchPilot>().Length, Is.EqualTo(count));
    }

    [UnityTest]
    public IEnumerator Fireflies_BlinkAtDusk_NotByDay([Values(0f, 1f)] float dusk)
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 0f);
        DrawnScreen.Slide("Dusk", dusk);
        float brightest = 0f;
        for (int frame = 0; frame < 180; frame++)
        {
            brightest = Mathf.Max(brightest, Sample.GetComponentsInChildren<Light>().Where(light => light.type == LightType.Point)
                .Max(light => light.intensity));
            yield return null;
        }

        Assert.That(brightest, dusk > 0f ? Is.GreaterThan(1f) : Is.Zero);
    }

    private IEnumerator Swim(int seconds)
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 0f);
        InsectFlight fish = Sample.GetComponentsInChildren<InsectFlight>().Single(flight => flight.name == "Snailfish");
        yield return Frames(20 * 60);
        float turned = 0f;
        Vector3 before = fish.Position;
        for (int frame = 0; frame < 60 * seconds; frame++)
        {
            yield return null;
            Assert.That((fish.Problem, fish.State), Is.EqualTo((FlightProblem.None, FlightState.Flying)), $"frame {frame}");
            Assert.That(new Vector2(fish.Position.x, fish.Position.z).magnitude, Is.EqualTo(20f).Within(3f), $"frame {frame}");
            Assert.That(fish.Position.y, Is.EqualTo(-3f).Within(1.5f), $"frame {frame}");
            turned += Vector3.SignedAngle(before, fish.Position, Vector3.up);
            before = fish.Position;
        }

        // Within one degree for each second.
        Assert.That(Mathf.Abs(turned), Is.EqualTo(Mathf.Rad2Deg * seconds * 0.2f * 10f / 20f).Within(seconds));
    }
}
