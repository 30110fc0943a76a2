using System.Collections;
using System.IO;
using System.Linq;
using Alate.Flight;
using Alate.Cli;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play;

/// <summary>The script of the manual's page on butterflies, in play.</summary>
public sealed class ButterflyPageTests : PlayFixture
{
    [Test]
    public void ThePage_HasTheScriptThatIsTested()
    {
        string script = File.ReadAllText(Path.Combine(
            PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Pages", nameof(ButterflyGlade) + ".cs"));
        Assert.That(PageCode.Of("butterflies.md").Single(), Is.EqualTo(script));
    }

    [UnityTest]
    [Explicit]
    [Category("Long")]
    public IEnumerator ItsButterflies_LandOnFlowers_AndFleeFromThePlayer()
    {
        Transform player = Keep(new GameObject("Player")).transform;
        player.position = new Vector3(0f, 2f, -200f);
        Transform[] flowers = Enumerable.Range(0, 6).Select(k => Keep(new GameObject("Flower")).transform).ToArray();
        for (int k = 0; k < flowers.Length; k++)
            flowers[k].position = new Vector3(4f * (k % 3 - 1), 1f, k / 3 * 4f - 2f);
        GameObject glade = Keep(new GameObject("Glade"));
        glade.SetActive(false);
        ButterflyGlade butterflies = glade.AddComponent<ButterflyGlade>();
        butterflies.SetUp(player, flowers, 5);
        glade.SetActive(true);
        yield return null;
        InsectFlight[] flights = glade.GetComponentsInChildren<InsectFlight>();
        Assert.That(flights, Has.Length.EqualTo(5));
        int most = 0;
        for (int frame = 0; frame < 60 * 60; frame++)
        {
            yield return null;
            most = Mathf.Max(most, butterflies.Sitting);
            Assert.That(butterflies.Sitting, Is.EqualTo(flights.Count(flight => flight.State == FlightState.Perched)).Within(1));
        }

        Assert.That(most, Is.GreaterThanOrEqualTo(2), "butterflies that sat at once");
        Assert.That(flights.Select(flight => flight.Problem), Has.All.EqualTo(FlightProblem.None));
        InsectFlight sitting = null;
        for (int frame = 0; frame < 3000 && sitting == null; frame++)
        {
            yield return null;
            sitting = flights.FirstOrDefault(flight => flight.State == FlightState.Perched);
        }

        Assert.That(sitting != null, "none sat within 50 s");
        player.position = sitting.Position + Vector3.back;
        for (int frame = 0; frame < 180; frame++)
            yield return null;
        Assert.That(sitting.State, Is.Not.EqualTo(FlightState.Perched), "three seconds after the player came");
    }
}
