using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using Alate.Samples;
using Alate.Showcase;
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

    // But for the flower that it comes to or has just left. Frames later the same butterflies fly other ways.
    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator ForAMinute_NobodyPassesThroughAFlower_OrComesToTheGround([Values(0, 1, 2, 5)] int later)
    {
        yield return Begin();
        yield return Frames(later);
        DrawnScreen.Slide("Butterflies", 12f);
        yield return Frames(60);
        PerchMark[] marks = Sample.GetComponentsInChildren<PerchMark>();
        var last = new Dictionary<InsectFlight, PerchMark>();
        int sat = 0;
        for (int frame = 0; frame < 3600; frame++)
        {
            yield return null;
            foreach (InsectFlight flight in Sample.GetComponentsInChildren<InsectFlight>().Where(flight => flight.name != "Snailfish"))
            {
                if (marks.FirstOrDefault(mark => mark.Guest != null && mark.Guest.gameObject == flight.gameObject) is { } own)
                    last[flight] = own;
                sat += flight.State == FlightState.Perched ? 1 : 0;
                Assert.That(flight.Position.y, Is.GreaterThan(1f), $"{flight.name} at {frame / 60f:0.0} s");
                foreach (PerchMark mark in marks.Where(mark => mark != last.GetValueOrDefault(flight)))
                {
                    Vector3 from = mark.transform.InverseTransformPoint(flight.Position);
                    bool isAbove = new Vector2(from.x, from.z).magnitude < 1f;
                    Assert.That(isAbove && from.y is > -0.3f and < 0.15f, Is.False,
                        $"{flight.name} passes through a flower at {frame / 60f:0.0} s");
                }
            }
        }

        Assert.That(sat, Is.GreaterThan(600), "ten seconds of sitting, of all together");
    }

    // Seen in the meshes themselves. Basking opens the wings again: they are closed for a third of a second at a time.
    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator WhoSits_StandsOnItsFeet_WithItsWingsClosed_AloneOnItsFlower()
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 12f);
        DrawnScreen.Slide("Shy", 0f);
        yield return Frames(60);
        PerchMark[] marks = Sample.GetComponentsInChildren<PerchMark>();
        var still = new Dictionary<InsectFlight, int>();
        int seen = 0;
        for (int frame = 0; frame < 3600; frame++)
        {
            yield return null;
            foreach (InsectFlight flight in Sample.GetComponentsInChildren<InsectFlight>())
            {
                bool isClosed = flight.State == FlightState.Perched && flight.GetComponent<PerchPilot>().Fold > 0.99f;
                still[flight] = isClosed ? still.GetValueOrDefault(flight) + 1 : 0;
                if (still[flight] != 10)
                    continue;
                seen++;
                PerchMark own = marks.Single(mark => mark.Guest != null && mark.Guest.gameObject == flight.gameObject);
                AssertSits(flight, own.transform, $"{flight.name} at {frame / 60f:0.0} s");
                foreach (InsectFlight other in Sample.GetComponentsInChildren<InsectFlight>().Where(other => other != flight))
                {
                    Assert.That(Vector3.Distance(other.Position, own.transform.position), Is.GreaterThan(0.5f),
                        $"{other.name} comes to the flower of {flight.name}");
                }
            }
        }

        Assert.That(seen, Is.GreaterThan(10));
    }

    [UnityTest]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
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

    // The camera comes near once, and from then on goes along.
    [UnityTest]
    public IEnumerator TheCamera_FollowsTheButterflyThatIsWatched()
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 3f);
        yield return Frames(30);
        OrbitCamera camera = Sample.GetComponentInChildren<OrbitCamera>();
        float far = camera.Distance;
        DrawnScreen.Slide("Shy", 0f);
        DrawnScreen.Slide("Watch", 2f);
        yield return Frames(120);
        InsectFlight watched = Sample.GetComponentsInChildren<PerchPilot>()[1].GetComponent<InsectFlight>();
        Assert.That(camera.Distance, Is.LessThan(0.5f * far));
        for (int frame = 0; frame < 120; frame++)
        {
            Assert.That(Vector3.Distance(camera.Target, watched.Position), Is.LessThan(6f), "it lags by a third of a second");
            yield return null;
        }

        camera.Distance = 9f;
        yield return Frames(5);
        Assert.That(camera.Distance, Is.EqualTo(9f), "the wheel counts");
        DrawnScreen.Slide("Watch", 0f);
        yield return Frames(5);
        Vector3 target = camera.Target;
        yield return Frames(30);
        Assert.That(camera.Target, Is.EqualTo(target));
    }

    [UnityTest]
    public IEnumerator WhoIsNotShy_Stays([Values(0f, 6f)] float shy)
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 2f);
        DrawnScreen.Slide("Shy", shy);
        yield return Frames(20);
        Assert.That(Sample.GetComponentsInChildren<PerchPilot>().Select(pilot => pilot.Settings.fleeDistance),
            Is.All.EqualTo(shy).Within(0.05f));
    }

    // The light that the scene had comes back.
    [UnityTest]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public IEnumerator AtNight_SunAndSurroundingsAreDim_UntilTheSampleEnds()
    {
        Color sky = RenderSettings.ambientSkyColor;
        yield return Begin();
        Light sun = Sample.GetComponentsInChildren<Light>().Single(light => light.type == LightType.Directional);
        DrawnScreen.Slide("Dusk", 0f);
        yield return Frames(5);
        (float day, float around) = (sun.intensity, RenderSettings.ambientSkyColor.g);
        Assert.That(sun.shadows, Is.Not.EqualTo(LightShadows.None));
        Assert.That(sun.transform.forward.y, Is.LessThan(-0.5f), "noon");
        DrawnScreen.Slide("Dusk", 1f);
        yield return Frames(5);
        Assert.That(sun.intensity, Is.LessThan(0.2f * day));
        Assert.That(RenderSettings.ambientSkyColor.g, Is.LessThan(0.5f * around));
        Object.Destroy(Sample.gameObject);
        yield return Frames(2);
        Assert.That(RenderSettings.ambientSkyColor, Is.EqualTo(sky));
    }

    [UnityTest]
    public IEnumerator Fireflies_BlinkAtDusk_NotByDay([Values(0f, 1f)] float dusk)
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 0f);
        DrawnScreen.Slide("Dusk", dusk);
        float brightest = 0f;
        int flashes = 0;
        for (int frame = 0; frame < 180; frame++)
        {
            MeshRenderer[] glows = [.. Sample.GetComponentsInChildren<Light>().Select(light => light.GetComponent<MeshRenderer>())
                .Where(glow => glow != null)];
            Assert.That(glows.Select(glow => glow.enabled), Is.EqualTo(glows.Select(glow => glow.GetComponent<Light>().intensity > 0f)));
            flashes += glows.Count(glow => glow.enabled);
            brightest = Mathf.Max(brightest, Sample.GetComponentsInChildren<Light>().Where(light => light.type == LightType.Point)
                .Max(light => light.intensity));
            yield return null;
        }

        Assert.That(brightest, dusk > 0f ? Is.GreaterThan(1f) : Is.Zero);
        Assert.That(flashes, dusk > 0f ? Is.GreaterThan(10) : Is.Zero, "a glow that is seen from afar");
    }

    [UnityTest]
    public IEnumerator InTheWind_FlowersSwayAboutTheirFeet_AndStandAsBeforeInACalm()
    {
        yield return Begin();
        PerchMark[] marks = Sample.GetComponentsInChildren<PerchMark>();
        Vector3[] before = [.. marks.Select(mark => mark.transform.position)];
        DrawnScreen.Slide("Wind", 2f);
        float[] farthest = new float[marks.Length], least = [.. before.Select(_ => float.PositiveInfinity)];
        for (int frame = 0; frame < 120; frame++)
        {
            yield return null;
            for (int k = 0; k < marks.Length; k++)
            {
                float off = Vector3.Distance(marks[k].transform.position, before[k]);
                farthest[k] = Mathf.Max(farthest[k], off);
                least[k] = Mathf.Min(least[k], off);
            }
        }

        Assert.That(farthest, Is.All.InRange(0.2f, 1f), "2 to 10 cm of the insects' own size");
        Assert.That(farthest.Zip(least, (most, few) => most - few), Is.All.GreaterThan(0.15f));
        DrawnScreen.Slide("Wind", 0f);
        yield return Frames(2);
        Assert.That(marks.Select(mark => mark.transform.position), Is.EqualTo(before));
    }

    // As it is drawn, whatever the flower does.
    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator InTheWind_WhoSits_SwaysAlong()
    {
        yield return Begin();
        DrawnScreen.Slide("Butterflies", 12f);
        DrawnScreen.Slide("Shy", 0f);
        DrawnScreen.Slide("Wind", 0.5f);
        yield return Frames(60);
        PerchMark[] marks = Sample.GetComponentsInChildren<PerchMark>();
        var stays = new Dictionary<PerchPilot, Vector3>();
        int seen = 0;
        for (int frame = 0; frame < 3600; frame++)
        {
            yield return new WaitForEndOfFrame();
            foreach (PerchPilot gone in stays.Keys.Where(pilot => pilot.Stage != PerchStage.Perched).ToList())
                stays.Remove(gone);
            foreach (PerchPilot pilot in Sample.GetComponentsInChildren<PerchPilot>().Where(pilot => pilot.Stage == PerchStage.Perched))
            {
                InsectFlight flight = pilot.GetComponent<InsectFlight>();
                if (flight.State != FlightState.Perched)
                    continue;
                Transform flower = marks.Single(mark => mark.Guest == pilot).transform;
                Vector3 place = flower.InverseTransformPoint(flight.transform.position);
                if (stays.TryGetValue(pilot, out Vector3 before))
                    Assert.That(Vector3.Distance(place, before), Is.LessThan(1e-3f), $"{flight.name} at {frame / 60f:0.0} s");
                stays[pilot] = before == default ? place : before;
                seen++;
            }
        }

        Assert.That(seen, Is.GreaterThan(3000), "a minute of sitting, of all together");
    }

    private static void AssertSits(InsectFlight flight, Transform flower, string who)
    {
        InsectWings insect = flight.GetComponent<InsectWings>();
        MeshFilter[] wings = [.. insect.Wings.Select(wing => wing.Renderer.GetComponent<MeshFilter>())];
        Vector3[] body = [.. insect.GetComponentsInChildren<MeshFilter>().Except(wings).SelectMany(mesh => Seen(mesh, flower))];
        float lowest = body.Min(place => place.y);
        Vector3[] ends = [.. wings.Select(mesh => Seen(mesh, flower).MaxBy(place => place.sqrMagnitude))];
        float lowestWing = wings.SelectMany(mesh => Seen(mesh, flower)).Min(place => place.y);
        Assert.That(lowest, Is.EqualTo(0f).Within(0.01f), $"{who}: its feet");
        Assert.That(lowestWing, Is.GreaterThan(0.03f), $"{who}: its wings reach into the flower");
        Assert.That(Vector3.Distance(ends[0], ends[1]), Is.LessThan(0.3f * ends[0].magnitude), $"{who}: its wings are open");
    }

    private static IEnumerable<Vector3> Seen(MeshFilter mesh, Transform from)
    {
        // What no triangle shows, far insects do not move.
        Vector3[] places = mesh.sharedMesh.vertices;
        return mesh.sharedMesh.triangles.Distinct().Select(corner =>
            from.InverseTransformPoint(mesh.transform.TransformPoint(places[corner])));
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
