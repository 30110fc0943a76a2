using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using UnityEngine;
using OwnWing = Alate.Tests.Cli.OwnWing;

namespace Alate.Tests.Views;

/// <summary>Messages of the live page beside the objects they tell of, and what they leave behind.</summary>
public sealed class SceneLaws
{
    // The body, and behind it the abdomen from its hinge where it swings.
    private static void AssertBody(JsonObject scene, SurfaceMesh body)
    {
        JsonNode[] parts = [scene["body"], .. scene["abdomen"] is { } abdomen ? [abdomen] : Array.Empty<JsonNode>()];
        IEnumerable<float3> places = parts.SelectMany(part => Vectors(part["positions"]).Select(place => place + HingeOf(part)));
        Assert.That(places.Zip(body.positions, (told, own) => math.distance(told, new float3(-own.x, own.y, own.z))),
            Has.Exactly(body.VertexCount).LessThan(1e-7f));
        Assert.That(parts.SelectMany(part => Vectors(part["normals"])).Zip(body.normals,
            (told, own) => math.distance(told, math.normalize(new float3(-own.x, own.y, own.z)))), Is.All.LessThan(1e-5f));
        Assert.That(parts.SelectMany(part => Read<Color32>(part["colours"])), Is.EqualTo(body.colours));
        int trunk = Vectors(parts[0]["positions"]).Count();
        IEnumerable<int> corners = parts.SelectMany((part, k) => Read<int>(part["triangles"]).Select(vertex => vertex + k * trunk));
        AssertMirrored([.. corners], body.triangles);

        static float3 HingeOf(JsonNode part) => part["hinge"] is { } hinge
            ? new float3((float)hinge[0], (float)hinge[1], (float)hinge[2])
            : default;
    }

    [TestCase("monarch")]
    [TestCase("fishfly", Explicit = true, Category = "Long")]
    [TestCase("snailfish", Explicit = true, Category = "Long")]
    public void AScene_HasBodyWingsAndLooks_InTheAxesOfTheFile(string species)
    {
        InsectDefinition definition = InsectCatalogue.Find(species);
        var settings = ViewSettings.Of(definition, InsectVariant.Standard);
        FlightPlan plan = settings.Plan(ComparisonColumn.FullModel);
        var insect = Insect.Of(plan);
        using var wings = new TetheredWings(plan, insect);
        JsonObject scene = SceneMessage.Scene(insect, wings.All, ComparisonColumn.All, settings, "a remark", true);
        double body = insect.Body.positions.Max(place => place.magnitude),
            reach = wings.All.Max(wing => math.length(wing.Placement.Hinge) + wing.Placement.Length);

        Assert.That(((string)scene["type"], (string)scene["name"], (string)scene["title"], (string)scene["remark"], (bool)scene["own"]),
            Is.EqualTo(("scene", species, definition.DisplayName, "a remark", true)));
        Assert.That((float)scene["reach"], Is.EqualTo(Math.Max(body, reach)).Within(1e-6));
        Assert.That(scene["columns"].AsArray().Select(column => ((string)column["title"], (string)column["description"])),
            Is.EqualTo(ComparisonColumn.All.Select(column => (column.Title, column.Description))));
        AssertBody(scene, insect.Body);
        for (int k = 0; k < wings.All.Count; k++)
        {
            RecordedWing wing = wings.All[k];
            JsonNode told = scene["wings"][k];
            Assert.That(((string)told["name"], (string)told["side"], (int)told["texture"], (int)told["chains"], (int)told["joints"]),
                Is.EqualTo((wing.Wing.Name, k % 2 == 0 ? "right" : "left", k / 2, wing.ChainCount, wing.JointsPerChain)));
            // Of glass, most of what is seen is seen through; what is cut has nothing around it.
            byte[] opacities = [.. (wing.Wing.Texture?.Pixels ?? wing.Wing.Colours ?? []).Select(pixel => pixel.a).Order()];
            bool isGlass = opacities.Length > 0 && opacities.First(opacity => opacity > 0) < 255
                && opacities.SkipWhile(opacity => opacity == 0).Count(opacity => opacity < 250) > 0.1 * opacities.Length;
            Assert.That(((bool)told["glass"], (bool)told["cut"]),
                Is.EqualTo((isGlass, !isGlass && wing.Wing.Texture != null && opacities[0] == 0)));
            // Pictures have their rows from above.
            Assert.That(Read<Vector2>(told["uvs"]), Is.EqualTo(wing.Wing.Surface.uvs.Select(uv => new Vector2(uv.x, 1f - uv.y))));
            Assert.That(told["colours"] == null, Is.EqualTo(wing.Wing.Texture != null || wing.Wing.Colours == null));
            Assert.That(Convert.FromBase64String((string)scene["textures"][k / 2]), Is.EqualTo(wing.Wing.Texture.Png));
            int[] triangles = Read<int>(told["triangles"]);
            if (k % 2 == 1 == wing.IsMeshMirrored)
                AssertMirrored(triangles, wing.Triangles);
            else
                Assert.That(triangles, Is.EqualTo(wing.Triangles));
        }

        JsonObject look = SceneMessage.DetachLook(scene);
        Assert.That(look.Select(part => part.Key), Is.EqualTo(new[] { "body", "abdomen", "textures", "wings" }));
        Assert.That(scene.ContainsKey("body") || scene.ContainsKey("textures") || scene.ContainsKey("wings"), Is.False);
    }

    [Test]
    public void TheFirstMessage_ListsTheSpeciesAndTheSliders_AndSettingsTellTheirValues()
    {
        JsonObject hello = SceneMessage.Hello(InsectCatalogue.All, ViewSlider.All);

        Assert.That((string)hello["type"], Is.EqualTo("hello"));
        Assert.That(hello["species"].AsArray().Select(one => ((string)one["name"], (string)one["title"],
                string.Join(' ', one["variants"].AsArray().Select(variant => (string)variant)))),
            Is.EqualTo(InsectCatalogue.All.Select(one => (one.Name, one.DisplayName, string.Join(' ', one.Variants).ToLowerInvariant()))));
        Assert.That(hello["sliders"].AsArray().Select(one => ((string)one["name"], (string)one["title"], (string)one["unit"],
            (double)one["min"],
                (double)one["max"], (bool)one["logarithmic"], (bool)one["whole"])),
            Is.EqualTo(ViewSlider.All.Select(one => (one.Name, one.Title, one.Unit, one.Min, one.Max, one.IsLogarithmic, one.IsWhole))));
        Assert.That(ViewSlider.SlowMotion.Name, Is.EqualTo("slow"));
        foreach (InsectDefinition species in InsectCatalogue.All)
        {
            foreach (InsectVariant variant in species.Variants)
            {
                var settings = ViewSettings.Of(species, variant);
                WingPreset preset = species.Wings[0].CreatePreset(ModelReading.Physical, variant);
                JsonObject told = SceneMessage.Settings(settings with { IsCompared = true });
                Assert.That(((string)told["type"], (string)told["species"], (string)told["variant"], (bool)told["compare"],
                    (bool)told["paused"]),
                    Is.EqualTo(("settings", species.Name, variant.ToString().ToLowerInvariant(), true, false)));
                double cruise = Math.Round(0.65 * species.Wings[0].CreatePreset().Beat.maxSpeed, 3);
                foreach ((string name, double value) in new[]
                {
                    ("slow", Math.Round(Math.Clamp(0.8 / preset.Beat.maxFrequency, 0.001, 1), 3)), ("speed", cruise), ("wind", 0),
                        ("elasticity", 1),
                    ("delay", Math.Round(preset.Wave.chordDelay, 4)), ("amplitude", 1), ("frequency", 1),
                        ("substeps", preset.SubstepsPerBeat),
                })
                {
                    Assert.That((double)told["values"][name], Is.EqualTo(value).Within(1e-6), $"{species.Name} {variant} {name}");
                }

                Assert.That(settings.Columns, Has.Count.EqualTo(1));
                Assert.That((settings with { IsCompared = true }).Columns, Is.EqualTo(ComparisonColumn.All));
                Assert.That(settings.Plan(ComparisonColumn.RigidWing).Lag ?? settings.Plan(ComparisonColumn.NoWave).Lag, Is.Null);
                Assert.That(settings.Plan(ComparisonColumn.FullModel).Lag, Is.EqualTo(settings.Flight.Lag).And.Not.Null);
                UnityEngine.Object.DestroyImmediate(preset);
            }
        }
    }

    [Test]
    public void ARequest_ChangesWhatItNames_AndAnotherInsectBringsItsOwnNumbers()
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        ViewSettings before = ViewSettings.Of(monarch, InsectVariant.Standard) with { IsCompared = true, IsPaused = true };
        ViewSettings Apply(string text) => ViewRequest.Read(Encoding.UTF8.GetBytes(text)).Apply(before);

        Assert.That(Apply("{}"), Is.EqualTo(before));
        ViewSettings changed = Apply("{\"values\":{\"speed\":2,\"slow\":0.5},\"paused\":false}");
        Assert.That((changed.Flight.Speed, changed.Slow, changed.IsPaused, changed.IsCompared), Is.EqualTo((2.0, 0.5, false, true)));
        Assert.That(changed with { Flight = changed.Flight with { Speed = before.Flight.Speed }, Slow = before.Slow, IsPaused = true },
            Is.EqualTo(before));
        Assert.That(Apply("{\"compare\":false}").IsCompared, Is.False);
        ViewSettings other = Apply("{\"species\":\"fishfly\"}"), soft = Apply("{\"variant\":\"expressive\"}");
        Assert.That(other.Flight, Is.EqualTo(ViewSettings.Of(InsectCatalogue.Find("fishfly"), InsectVariant.Standard).Flight)
            .Using<FlightPlan>((a, b) => (a with { Wind = null }) == (b with { Wind = null })));
        Assert.That((other.IsCompared, other.IsPaused, soft.Species, soft.Variant),
            Is.EqualTo((true, false, "monarch", InsectVariant.Expressive))
            .Or.EqualTo((true, true, "monarch", InsectVariant.Expressive)));
        var file = ViewRequest.Read(Encoding.UTF8.GetBytes($"{{\"file\":\"{new string('x', 300)}\",\"save\":true,\"catalogue\":true}}"));
        Assert.That((file.Files.Single().Length, file.IsSave, file.IsCatalogue), Is.EqualTo((200, true, true)));
    }

    [Test]
    public void ABuffer_KeepsWhatIsAdded_GrowsAndIsEmptied()
    {
        var buffer = new StateBuffer();
        buffer.Add(7u);
        buffer.Add(1.5f);
        buffer.Add(2.5);
        buffer.Add(new float3(1f, 2f, 3f));
        buffer.Add<short>(3)[2] = 9;
        byte[] first = buffer.Content.ToArray();

        Assert.That((BitConverter.ToUInt32(first, 0), BitConverter.ToSingle(first, 4), BitConverter.ToDouble(first, 8)),
            Is.EqualTo((7u, 1.5f, 2.5)));
        Assert.That((BitConverter.ToSingle(first, 16), BitConverter.ToSingle(first, 24), BitConverter.ToInt16(first, 32)),
            Is.EqualTo((1f, 3f, (short)9)));
        Assert.That((buffer.Length, first.Length), Is.EqualTo((34, 34)));
        buffer.Add(new byte[300_000]);
        Assert.That(buffer.Length, Is.EqualTo(300_034));
        Assert.That(buffer.Content.ToArray()[..34], Is.EqualTo(first));
        buffer.Clear();
        Assert.That(buffer.Length, Is.Zero);
    }

    // A stray triangle far beyond the wing, and a wing so soft that it tears: what has no room in a message stands at its limit.
    [Test]
    public void WhatIsBeyondTheRoomOfAMessage_StandsAtItsLimit()
    {
        using var run = new CommandRun();
        string obj = OwnWing.Obj();
        int count = obj.Split('\n').Count(line => line.StartsWith("v "));
        Vector3 tip = ObjReader.Read(new StringReader(obj)).Positions.MaxBy(place => place.magnitude);
        tip = new Vector3(0.5f * tip.x, 0f, 9f * tip.magnitude);
        string stray = FormattableString.Invariant(
            $"v {tip.x} {tip.y} {tip.z}\nv {1.01f * tip.x} {tip.y} {tip.z}\nv {tip.x} {tip.y} {1.01f * tip.z + 0.01f}\n")
            + $"f {count + 1} {count + 2} {count + 3}\n";
        var plan = new FlightPlan
        {
            Species = "monarch",
            MeshFile = run.Write("wing.obj", obj + stray),
            SkeletonFile = run.Write("wing.json", OwnWing.Skeleton()),
        };
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        var before = new ViewState(LiveWakeTests.Told(flight));
        Assert.That(before.Beats[0], Is.InRange(0.0, 1.0), "not before the start");
        for (int k = 0; k < 30; k++)
        {
            flight.Advance(1e-9 * (k + 1));
            Assert.That(new ViewState(LiveWakeTests.Told(flight)).Beats[0], Is.InRange(0.0, 0.01), "nor by rounding");
        }

        flight.Advance(0.1);
        var state = new ViewState(LiveWakeTests.Told(flight));
        ViewState.Wing wing = state.Wings[0][0];

        Assert.That(wing.Places.Skip(count).Take(3).Select(place => math.cmax(math.abs(place))),
            Is.All.EqualTo(wing.Reach).Within(1e-4f * wing.Reach));
        Assert.That(math.cmax(wing.Places.Skip(count).Take(3).Select(math.abs).Aggregate(math.max)), Is.LessThanOrEqualTo(wing.Reach));
        Assert.That(wing.Places.Take(count).Max(place => math.length(place)), Is.LessThan(0.6f * wing.Reach), "the wing itself has room");
    }

    [Test]
    public void AStretchBeyondAQuarter_IsTheLargestThatAMessageTells()
    {
        FlightPlan plan = new FlightPlan { Species = "firefly", Wind = [0, 0, -12] }.AsVersion01();
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        int beyond = 0;
        for (int k = 0; k < 20; k++)
        {
            flight.Advance(0.1 / flight.Frequency);
            var state = new ViewState(LiveWakeTests.Told(flight));
            for (int wing = 0; wing < state.Wings[0].Count; wing++)
            {
                // From the places that are told: metres, in steps of a few thousandths of a millimetre.
                RecordedWing recorded = flight.Wings[wing];
                ViewState.Wing told = state.Wings[0][wing];
                float[] stretch = new float[recorded.Rest.Length];
                for (int corner = 0; corner < recorded.Triangles.Length; corner++)
                {
                    int a = recorded.Triangles[corner], b = recorded.Triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
                    float now = math.distance(told.Places[a], told.Places[b]) / recorded.Placement.Length,
                        rest = math.distance(recorded.Rest[a], recorded.Rest[b]);
                    float own = rest < 0.005f ? 0f : math.abs(now / rest - 1f);
                    (stretch[a], stretch[b]) = (math.max(stretch[a], own), math.max(stretch[b], own));
                }

                for (int vertex = 0; vertex < stretch.Length; vertex++)
                {
                    if (stretch[vertex] < 0.27f)
                        continue;
                    beyond++;
                    Assert.That(told.StretchPct[vertex], Is.EqualTo(25.5f).Within(1e-3f), $"255 thousandths, not {1000 * stretch[vertex]}");
                }

                Assert.That(told.Attack.Max(), Is.LessThanOrEqualTo(90));
            }
        }

        Assert.That(beyond, Is.GreaterThan(20));
    }

    [Test]
    public void AServer_MakesTheFirstInsectAtOnce_AndLeavesNothingOfIt_WhereNoPageOpens()
    {
        int before = NativeMemoryLedger.LiveCount;
        ViewServer server = ViewServer.Start(new InsectView(InsectCatalogue.Find("monarch"), InsectVariant.Standard), 0, ThreeSource.Public)
            .GetAwaiter().GetResult();
        server.Simulation.RunUntil(server.Simulation.Do(() => { }));
        Assert.That(NativeMemoryLedger.LiveCount, Is.GreaterThan(before), "nothing is made before a page opens");
        server.Simulation.RunUntil(server.Stop());
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before), NativeMemoryLedger.Describe());
    }

    [Test]
    public void Insects_LeaveNoNativeMemory_WhenTheyAreChangedSavedAndClosed()
    {
        int before = NativeMemoryLedger.LiveCount;
        using (var scene = new SceneInsect(ViewSettings.Of(InsectCatalogue.Find("monarch"), InsectVariant.Standard)))
        {
            int one = NativeMemoryLedger.LiveCount;
            Assert.That(one, Is.GreaterThan(before));
            using var baked = new MemoryStream();
            scene.Bake(3, baked);
            AssertBeat(baked.ToArray(), 3);
            Assert.That(scene.Change(Request("{\"compare\":true}")), Is.True);
            int four = NativeMemoryLedger.LiveCount;
            Assert.That(scene.Change(Request("{\"compare\":false}")), Is.True);
            Assert.That((NativeMemoryLedger.LiveCount, four > one), Is.EqualTo((one, true)), NativeMemoryLedger.Describe());
            Assert.That(scene.Change(Request("{\"values\":{\"speed\":2}}")), Is.False);
            Assert.That(scene.Settings.Flight.Speed, Is.EqualTo(2));
            Assert.That(BitConverter.ToUInt32(scene.Save()), Is.EqualTo(0x46546C67u), "glTF");
            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(one), NativeMemoryLedger.Describe());
            Assert.That(() => scene.Wear("wing.obj", "v 0 0 0"u8.ToArray()), Throws.TypeOf<UserException>());
            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(one), NativeMemoryLedger.Describe());
        }

        var plan = new FlightPlan { Species = "monarch", Substeps = 12, Patches = 64 };
        using (var tunnel = new WindTunnel(plan, Insect.Of(plan).Wings[0]))
            tunnel.Measure(0.0, false);
        Comparison.Fly(new ComparisonPlan([plan], [ComparisonColumn.FullModel], 1), _ => { });
        Assert.That(() => new TetheredFlight(plan with { Seconds = 1e-4 }, Insect.Of(plan)), Throws.TypeOf<UserException>());
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before), NativeMemoryLedger.Describe());
    }

    // States of equal steps over one settled beat, each with its length before it, numbered from one on.
    private static void AssertBeat(byte[] baked, int frames)
    {
        var states = new List<ViewState>();
        for (int at = 0; at < baked.Length;)
        {
            int length = BitConverter.ToInt32(baked, at);
            byte[] state = baked[(at + 4)..(at + 4 + length)];
            states.Add(new ViewState(state));
            Assert.That((states[^1].Magic, states[^1].Length, BitConverter.ToInt32(state, 16) - states.Count),
                Is.EqualTo((0x54414C41u, length, BitConverter.ToInt32(baked, 4 + 16) - 1)));
            at += 4 + length;
        }

        Assert.That(states, Has.Count.EqualTo(frames));
        Assert.That(states[0].Beats[0], Is.InRange(7.9, 9.5), "settled for eight beats");
        for (int k = 1; k < frames; k++)
            Assert.That(states[k].Beats[0] - states[k - 1].Beats[0], Is.EqualTo(1.0 / frames).Within(0.02));
    }

    private static ViewRequest Request(string text) => ViewRequest.Read(Encoding.UTF8.GetBytes(text));

    // The other way round, whichever corner comes first.
    private static void AssertMirrored(int[] told, int[] own)
    {
        Assert.That(told, Has.Length.EqualTo(own.Length));
        for (int k = 0; k < own.Length; k += 3)
        {
            int first = Array.IndexOf(told, own[k], k, 3) - k;
            Assert.That((told[k + (first + 1) % 3], told[k + (first + 2) % 3]), Is.EqualTo((own[k + 2], own[k + 1])));
        }
    }

    private static float3[] Vectors(JsonNode text) => Read<float3>(text);

    private static T[] Read<T>(JsonNode text) where T : struct => [.. MemoryMarshal.Cast<byte, T>(Convert.FromBase64String((string)text))];
}
