using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Views;

/// <summary>Insects of the live view that land on a perch.</summary>
public sealed class PerchFlightTests
{
    private const float k_Frame = 1f / 60f;

    [TestCase("monarch")]
    [TestCase("dragonfly", Explicit = true, Category = "Long")]
    public void AnInsect_ComesToThePerch_SitsOnItsFeet_AndTakesOffAgain(string species) => LandsAndLeaves(species);

    [TestCase("swallowtail")]
    [TestCase("firefly")]
    [TestCase("fishfly")]
    [TestCase("painted-lichen-moth")]
    [Explicit]
    [Category("Long")]
    public void EveryOtherInsect_DoesSoToo(string species) => LandsAndLeaves(species);

    private static void LandsAndLeaves(string species)
    {
        InsectDefinition definition = InsectCatalogue.Find(species);
        var settings = ViewSettings.Landing(definition);
        using var wings = new TetheredWings(settings.Flight, Insect.Of(settings.Flight));
        using var flight = new PerchFlight(definition, wings.All);
        // Those of the body that is drawn: the swallowtail's numbers of flight are of a larger one.
        WingPreset drawn = definition.Wings[0].CreatePreset();
        float3 feet = drawn.Rest.feet;
        UnityEngine.Object.DestroyImmediate(drawn);
        var states = new List<FlightState>();
        Assert.That(math.length(flight.Position), Is.GreaterThan(0.5f), "metres from the perch");
        float off = 0f;
        while (states.Count(state => state == FlightState.Perched) < 2 && flight.Time < 120)
        {
            flight.Advance(k_Frame);
            if (states.Count == 0 || states[^1] != flight.State)
                states.Add(flight.State);
            else if (flight.State == FlightState.Perched)
                off = math.max(off, math.length(flight.Position + feet));
        }

        Assert.That(states.Count(state => state == FlightState.Perched), Is.EqualTo(2), $"{flight.Time} s");
        Assert.That(states, Has.Member(FlightState.Landing).And.Member(FlightState.Flying));
        Assert.That(off, Is.LessThan(0.01f * wings.All[0].Placement.Length), "feet off the perch");
    }

    [Test]
    public void AState_TellsThePlace_TheTurnAndWhatTheInsectDoes_InTheAxesOfTheFile()
    {
        InsectDefinition definition = InsectCatalogue.Find("monarch");
        using var scene = new SceneInsect(ViewSettings.Landing(definition));
        var state = new StateBuffer();
        scene.Advance(state);
        float[] place = MemoryMarshal.Cast<byte, float>(state.Content.Span[^32..^4]).ToArray();

        Assert.That(BitConverter.ToUInt32(state.Content.Span[20..]), Is.EqualTo(2u));
        Assert.That(math.length(new float3(place[0], place[1], place[2])), Is.InRange(0.5f, 1f), "metres");
        Assert.That((place[1], place[2]), Is.EqualTo((0.25f, -0.7f)).Using<(float, float)>(
            (a, b) => Math.Abs(a.Item1 - b.Item1) < 0.05f && Math.Abs(a.Item2 - b.Item2) < 0.05f), "above and behind");
        Assert.That(math.length(new float4(place[3], place[4], place[5], place[6])), Is.EqualTo(1f).Within(1e-4f));
        Assert.That((FlightState)BitConverter.ToUInt32(state.Content.Span[^4..]),
            Is.EqualTo(FlightState.Flying).Or.EqualTo(FlightState.Landing));
        Assert.That((bool)scene.Scene["settings"]["landing"], Is.True);
        float phase = BitConverter.ToSingle(state.Content.Span[24..]), told = BitConverter.ToSingle(state.Content.Span[48..]);
        float up = -math.radians(definition.Abdomen.swing) * math.cos(phase - math.radians(definition.Abdomen.lowestPhase));
        Assert.That(told, Is.EqualTo(up).Within(0.01f), "radians");
    }

    [TestCase(false)]
    [TestCase(true)]
    public void NormalsOfAState_AreUnitVectors(bool lands)
    {
        const int k_Head = 24, k_Flight = 36, k_Wing = 24;
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        using var scene = new SceneInsect(lands ? ViewSettings.Landing(monarch) : ViewSettings.Of(monarch, InsectVariant.Standard));
        var state = new StateBuffer();
        scene.Advance(state);
        ReadOnlySpan<byte> wing = state.Content.Span[(k_Head + k_Flight)..];
        int vertices = (int)BitConverter.ToUInt32(wing), joints = (int)BitConverter.ToUInt32(wing[4..]);
        ReadOnlySpan<sbyte> normals = MemoryMarshal.Cast<byte, sbyte>(
            wing.Slice(k_Wing + 2 * 12 * joints + 8 * vertices, 4 * vertices));

        Assert.That(vertices, Is.GreaterThan(100));
        for (int k = 0; k < normals.Length; k += 4)
            Assert.That(math.length(new float3(normals[k], normals[k + 1], normals[k + 2])), Is.InRange(125f, 127.5f), $"vertex {k / 4}");
    }

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void Landing_GoesOnWithAnotherInsect_AndEndsWithAVariant_OrOneThatSwims()
    {
        using var scene = new SceneInsect(ViewSettings.Of(InsectCatalogue.Find("monarch"), InsectVariant.Standard));
        bool Ask(string text) => scene.Change(ViewRequest.Read(Encoding.UTF8.GetBytes(text)));
        (string, InsectVariant, bool) Now() => (scene.Settings.Species, scene.Settings.Variant, scene.Settings.IsLanding);

        Assert.That(Ask("{\"landing\":true,\"compare\":true,\"wake\":true}"), Is.True, "another scene");
        Assert.That(Now(), Is.EqualTo(("monarch", InsectVariant.Flight, true)));
        Assert.That((scene.Settings.IsCompared, scene.Settings.HasWake), Is.EqualTo((false, false)));
        Assert.That(Ask("{\"species\":\"firefly\"}"), Is.True);
        Assert.That(Now(), Is.EqualTo(("firefly", InsectVariant.Flight, true)));
        Assert.That(Ask("{\"species\":\"firefly\",\"variant\":\"standard\"}"), Is.True);
        Assert.That(Now(), Is.EqualTo(("firefly", InsectVariant.Standard, false)));
        Ask("{\"landing\":true}");
        Ask("{\"species\":\"snailfish\"}");
        Assert.That(Now(), Is.EqualTo(("snailfish", InsectVariant.Standard, false)));
        UserException problem = Assert.Throws<UserException>(() => Ask("{\"landing\":true}"));
        Assert.That(problem.Message, Does.StartWith("The Snailfish does not land"));
        Ask("{\"species\":\"monarch\",\"landing\":true}");
        Ask("{\"landing\":false}");
        Assert.That(Now(), Is.EqualTo(("monarch", InsectVariant.Standard, false)));
    }

    [Test]
    public void TheFirstMessage_SaysWhichInsectsLand()
    {
        JsonArray species = SceneMessage.Hello(InsectCatalogue.All, ViewSlider.All)["species"].AsArray();
        Assert.That(species.Where(one => !(bool)one["lands"]).Select(one => (string)one["name"]), Is.EqualTo(new[] { "snailfish" }));
    }
}
