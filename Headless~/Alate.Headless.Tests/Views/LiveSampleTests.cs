using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.Json.Nodes;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Views;

/// <summary>Samples that play for a page: what their states tell, and what a page may ask of them.</summary>
public sealed class LiveSampleTests
{
    private const uint k_Skinned = 1, k_Baked = 2, k_Shadowless = 32;
    private const string k_Deformed = "Deformed by the graphics card";

    private readonly StateBuffer m_State = new();
    private readonly Dictionary<uint, SampleState.Mesh> m_Meshes = [];

    [SetUp]
    public void Forget() => m_Meshes.Clear();

    // Where the painter of the films has them, with the light that it has.
    [TestCase("garden")]
    [TestCase("insects")]
    [TestCase("monarch")]
    public void AState_DrawsWhatThePainterDraws(string scene)
    {
        using LiveSample sample = Play(scene);
        for (int k = 0; k < 5; k++)
            Next(sample);
        SampleState state = Next(sample);
        SceneShot shot = new SceneReader().Shot(Camera.main, new int2(160, 90));
        var expected = shot.Surfaces.Select(Summary).OrderBy(Order).ToList();
        var told = state.Draws.SelectMany(draw => draw.Instances.Select(instance => Summary(draw, instance))).OrderBy(Order).ToList();

        Assert.That(told, Has.Count.EqualTo(expected.Count));
        for (int k = 0; k < told.Count; k++)
        {
            Assert.That(told[k].Count, Is.EqualTo(expected[k].Count), $"triangles of {k}");
            Assert.That(math.distance(told[k].Middle, expected[k].Middle), Is.LessThan(1e-3f), $"place of {k}");
            Assert.That(math.distance(told[k].Normal, expected[k].Normal), Is.LessThan(0.02f), $"normals of {k}");
            Assert.That(math.distance(told[k].Tint, expected[k].Tint), Is.LessThan(1e-5f), $"tint of {k}");
            Assert.That(told[k].Underside, Is.EqualTo(expected[k].Underside), $"underside of {k}");
        }

        Assert.That(state.Draws.Where(draw => (draw.Flags & k_Shadowless) != 0).Sum(draw => draw.Instances.Count()),
            Is.EqualTo(shot.Surfaces.Count(surface => !surface.CastsShadow)).And.EqualTo(scene == "garden" ? 0 : 1), "walls of a studio");
        Assert.That((state.Sky, state.Equator, state.Ground, state.SunFrom, state.Sun, state.HasShadows),
            Is.EqualTo((shot.Light.Sky, shot.Light.Equator, shot.Light.Ground, shot.Light.SunFrom, shot.Light.Sun, shot.Light.HasShadows)));
        Assert.That(state.Lamps, Is.EqualTo(shot.Light.Lamps.Select(lamp => (lamp.Place, lamp.Light, lamp.Range))));
        Assert.That(state.Behind, Is.EqualTo(shot.Behind));
    }

    // The page finds the eye from the angles.
    [Test]
    public void TheCamera_IsWhereItsAnglesSay()
    {
        using LiveSample sample = Play("garden");
        SampleState state = Next(sample);
        float3 ahead = math.rotate(
            quaternion.EulerZXY(math.radians(state.Pitch), math.radians(state.Yaw), 0f), new float3(0f, 0f, state.Distance));

        Assert.That(math.distance(state.Target - ahead, Camera.main.transform.position), Is.LessThan(1e-3f));
        Assert.That((state.Opening, state.Nearest), Is.EqualTo((Camera.main.fieldOfView, Camera.main.nearClipPlane)));
        Assert.That((state.Magic, state.Sequence, state.Time), Is.EqualTo((0x53414c41u, 1u, 1.0 / 30.0)));
        Assert.That(state.Length, Is.EqualTo(m_State.Length), "bytes that nobody reads");
    }

    [Test]
    public void MeshesAndTextures_AreSentOnce_AndThoseThatBendAreSentAgain()
    {
        using LiveSample sample = Play("monarch");
        SampleState first = Next(sample), second = Next(sample);

        Assert.That(first.Meshes.Select(mesh => mesh.IsWhole), Is.All.True);
        Assert.That(first.Meshes.Select(mesh => mesh.Number), Is.SupersetOf(first.Draws.Select(draw => draw.Mesh).Distinct()));
        Assert.That(first.Maps.Select(map => map.Number),
            Is.SupersetOf(first.Draws.Select(draw => draw.Picture).Where(picture => picture > 0).Distinct()));
        Assert.That(second.Meshes.Select(mesh => mesh.IsWhole), Is.All.False);
        Assert.That(second.Meshes, Is.Not.Empty);
        Assert.That(second.Meshes.Count, Is.LessThan(first.Meshes.Count), "the body is sent again");
        Assert.That(second.Maps, Is.Empty);
        foreach (SampleState.Mesh mesh in second.Meshes)
        {
            Assert.That(mesh.Places.Zip(first.Meshes.Find(before => before.Number == mesh.Number).Places, math.distance).Max(),
                Is.GreaterThan(0f));
        }
    }

    [Test]
    public void APausedSample_StandsStill_AndItsCameraTurns()
    {
        using LiveSample sample = Play("monarch");
        Next(sample);
        sample.Change(Request("{\"paused\":true}"));
        SampleState before = Next(sample);
        sample.Change(Request("{\"look\":[7,30,-5,0.5,0.1,0.2,0.3]}"));
        SampleState after = Next(sample);

        Assert.That(after.Time, Is.EqualTo(before.Time));
        Assert.That(after.Meshes, Is.Empty);
        Assert.That((before.Look, after.Look), Is.EqualTo((0u, 7u)));
        Assert.That((after.Yaw - before.Yaw, after.Pitch - before.Pitch), Is.EqualTo((30f, -5f)));
        Assert.That(after.Distance, Is.EqualTo(0.5f * before.Distance).Within(1e-6f));
        Assert.That(math.distance(after.Target - before.Target, new float3(0.1f, 0.2f, 0.3f)), Is.LessThan(1e-5f));

        sample.Change(Request("{\"home\":true,\"paused\":false,\"aspect\":2}"));
        SampleState home = Next(sample);
        Assert.That((home.Yaw, home.Pitch, home.Distance, home.Target),
            Is.EqualTo((before.Yaw, before.Pitch, before.Distance, before.Target)));
        Assert.That(home.Time, Is.GreaterThan(after.Time));
        Assert.That(Camera.main.aspect, Is.EqualTo(2f));
    }

    [Test]
    public void ThePanel_IsTold_WhereItChanges_AndItsControlsAreMoved()
    {
        using LiveSample sample = Play("garden");
        Next(sample);
        JsonArray controls = Controls(sample.ChangedPanel());
        JsonNode butterflies = controls[0];

        Assert.That(controls.Select(control => (string)control["kind"]), Is.EqualTo(Enumerable.Repeat("slider", 6).Append("label")));
        Assert.That(((string)butterflies["name"], (float)butterflies["value"], (float)butterflies["min"], (float)butterflies["max"]),
            Is.EqualTo(("Butterflies", 8f, 0f, 60f)));
        sample.Change(Request("{\"slider\":{\"name\":\"Wind\",\"value\":1.5},\"paused\":true}"));
        JsonArray moved = Controls(sample.ChangedPanel());
        Assert.That((float)moved[1]["value"], Is.EqualTo(1.5f).Within(0.01f));
        Assert.That((string)moved[1]["text"], Is.EqualTo("Wind: 1.5 m/s"));
        Assert.That(sample.ChangedPanel(), Is.Null);
        Assert.That(moved.Select(control => (int)control["row"]), Is.EqualTo(new[] { 1, 3, 5, 7, 9, 11, 12 }));
        Assert.That(() => sample.Change(Request("{\"slider\":{\"name\":\"Moon\",\"value\":1}}")),
            Throws.TypeOf<UserException>().With.Message.Contain("'Moon'"));
        Assert.That(() => sample.Change(Request("{\"slider\":{\"name\":\"Dusk\",\"value\":2}}")), Throws.TypeOf<UserException>());
        Assert.That(() => sample.Change(Request("{\"press\":\"Dance\"}")), Throws.TypeOf<UserException>());
    }

    // Buttons that stand side by side.
    [Test]
    public void ARowOfThePanel_IsTold()
    {
        using LiveSample sample = Play("comparison");
        Next(sample);
        JsonNode[] buttons = [.. Controls(sample.ChangedPanel()).Where(control => (string)control["kind"] == "button")];

        Assert.That(buttons.Select(button => (string)button["text"]), Is.SupersetOf(new[] { "<", ">" }));
        Assert.That((int)buttons.First(button => (string)button["text"] == "<")["row"],
            Is.EqualTo((int)buttons.First(button => (string)button["text"] == ">")["row"]));
    }

    // A swarm is a few draws, and its joints come with every state; without the graphics card each wing is a mesh that bends.
    [Test]
    public void ASwarm_IsDrawnInInstances_WithItsJoints()
    {
        using LiveSample sample = Play("swarm");
        sample.Change(Request("{\"slider\":{\"name\":\"Insects\",\"value\":30}}"));
        for (int k = 0; k < 6; k++)
            Next(sample);
        SampleState state = Next(sample);
        SampleState.Draw[] skinned = [.. state.Draws.Where(draw => draw.Flags % 2 == k_Skinned)];

        Assert.That(skinned.Sum(draw => draw.Instances.Length), Is.GreaterThan(30));
        Assert.That(state.Draws, Has.Count.LessThan(12));
        foreach (SampleState.Draw draw in skinned)
        {
            int joints = state.Maps.Find(map => map.Number == draw.Map).Numbers.Length / 2;
            SampleState.Mesh mesh = m_Meshes[draw.Mesh];
            float most = mesh.Joints.Max(joint => joint.x + joint.y + 1f);
            Assert.That(draw.Instances.Max(instance => instance.rows.x) + most, Is.LessThan(joints));

            // Those out of sight are told no joints.
            float[] starts = [.. draw.Instances.Select(instance => instance.rows.x).Where(start => start > 0f)];
            Assert.That(starts, Has.Length.GreaterThan(3).And.Unique);
        }

        sample.Change(Request($"{{\"press\":\"{k_Deformed}\"}}"));
        Next(sample);
        SampleState plain = Next(sample);
        Assert.That(plain.Draws.Any(draw => draw.Flags % 2 == k_Skinned), Is.False);
        Assert.That(plain.Draws, Has.Count.GreaterThan(30));
    }

    [Test]
    public void InsectsThatAreGone_AreToldSo_AndTheirDrawsEnd()
    {
        using LiveSample sample = Play("garden");
        for (int k = 0; k < 10; k++)
            Next(sample);
        int before = Next(sample).Draws.Count;
        var gone = new List<uint>();
        sample.Change(Request("{\"slider\":{\"name\":\"Butterflies\",\"value\":0}}"));
        SampleState state = null;
        for (int k = 0; k < 4; k++)
        {
            state = Next(sample);
            gone.AddRange(state.GoneMeshes);
        }

        Assert.That(gone, Has.Count.GreaterThan(8).And.Unique);
        Assert.That(state.Draws, Has.Count.LessThan(before - 8));
        Assert.That(state.Draws.Select(draw => draw.Mesh).Intersect(gone), Is.Empty);
    }

    [Test]
    [Explicit]
    [Category("Long")]
    public void AMeadow_TellsItsBakedInsects_WithTheRowsOfTheirLoops()
    {
        using LiveSample sample = Play("meadow");
        SampleState first = Next(sample), state = Next(sample);
        SampleState.Draw[] baked = [.. state.Draws.Where(draw => (draw.Flags & k_Baked) != 0)];

        Assert.That(baked.Sum(draw => draw.Instances.Length), Is.GreaterThan(2000));
        Assert.That(state.Maps, Is.Empty, "loops are sent again");
        foreach (SampleState.Draw draw in baked)
        {
            int height = first.Maps.Find(map => map.Number == draw.Map).Height;
            Assert.That(draw.Instances.Select(instance => math.cmax(instance.rows.xy)), Is.All.InRange(0f, height / 2f));
            Assert.That(draw.Instances.Select(instance => instance.rows.z), Is.All.InRange(0f, 1f));
        }
    }

    [Test]
    public void AScene_WaitsForAPageThatTakesNothing()
    {
        using LiveSample sample = Play("monarch");
        for (int k = 0; k < 3; k++)
        {
            Assert.That(sample.IsAhead, Is.False, $"after {k} states");
            Next(sample);
        }

        Assert.That(sample.IsAhead, Is.True);
        sample.Change(Request("{\"seen\":1}"));
        Assert.That(sample.IsAhead, Is.False);
        sample.Change(Request("{\"seen\":99}"));
        sample.Change(Request("{\"seen\":0}"));
        for (int k = 0; k < 3; k++)
            Next(sample);
        Assert.That(sample.IsAhead, Is.True, "states count as seen that were never sent");
    }

    [Test]
    public void ASample_LeavesNothing()
    {
        int before = NativeMemoryLedger.LiveCount;
        using (LiveSample sample = Play("garden"))
            Next(sample);

        Assert.That((Application.isPlaying, NativeMemoryLedger.LiveCount), Is.EqualTo((false, before)), NativeMemoryLedger.Describe());
    }

    [TestCase("{\"look\":[1,2,3]}", "seven numbers")]
    [TestCase("{\"look\":[-1,0,0,1,0,0,0]}", "whole")]
    [TestCase("{\"look\":[1,0,0,1,0,0,\"x\"]}", "none of this page's")]
    [TestCase("{\"slider\":{\"name\":\"Dusk\"}}", "none of this page's")]
    [TestCase("{\"slider\":{\"name\":null,\"value\":1}}", "missing")]
    [TestCase("{\"seen\":1.5}", "whole")]
    [TestCase("{\"save\":true}", "has no 'save'")]
    [TestCase("[]", "none of this page's")]
    [TestCase("{", "none of this page's")]
    public void OtherMessages_AreRefused(string text, string said) =>
        Assert.That(() => Request(text), Throws.TypeOf<FormatException>().With.Message.Contain(said));

    // A hand that goes wild stays within what a camera bears.
    [Test]
    public void Looks_AreHeldWithinTheirBounds()
    {
        SampleLook look = Request("{\"look\":[1,1e9,-1e9,0,1e9,0,-1e9]}").Look;

        Assert.That((look.Yaw, look.Pitch, look.Zoom, look.Move), Is.EqualTo((360f, -360f, 0.01f, new float3(1000f, 0f, -1000f))));
        Assert.That(Request("{\"aspect\":0}").Aspect, Is.EqualTo(0.1));
    }

    private static LiveSample Play(string scene) => new(SampleScene.Find(scene));

    private static SampleRequest Request(string text) => SampleRequest.Read(Encoding.UTF8.GetBytes(text));

    private static JsonArray Controls(JsonObject panel) => (JsonArray)panel["controls"];

    private SampleState Next(LiveSample sample)
    {
        sample.Advance(m_State);
        var state = new SampleState(m_State.Content.ToArray());
        foreach (SampleState.Mesh mesh in state.Meshes)
        {
            if (!mesh.IsWhole)
                mesh.Parts.AddRange(m_Meshes[mesh.Number].Parts);
            m_Meshes[mesh.Number] = mesh;
        }

        return state;
    }

    private static (int Count, float3 Middle, float3 Normal, float4 Tint, float4 Underside) Summary(SceneSurface surface)
    {
        int[] used = [.. surface.Triangles.Distinct()];
        return (surface.Triangles.Length, Mean(used, surface.Places), Mean(used, surface.Normals), surface.Look.Tint,
            surface.Look.Underside);
    }

    private (int Count, float3 Middle, float3 Normal, float4 Tint, float4 Underside) Summary(
        SampleState.Draw draw, SampleState.Instance instance)
    {
        SampleState.Mesh mesh = m_Meshes[draw.Mesh];
        int[] used = [.. mesh.Parts[draw.Part].Distinct()];
        float3x3 turn = math.inverse(new float3x3(instance.x.xyz, instance.y.xyz, instance.z.xyz));
        return (mesh.Parts[draw.Part].Length, Mean(used, Array.ConvertAll(mesh.Places, instance.Place)),
            Mean(used, [.. mesh.Normals.Select(normal => math.normalizesafe(math.mul(turn, normal)))]), instance.tint, draw.Underside);
    }

    private static float3 Mean(int[] used, float3[] values) =>
        used.Aggregate(float3.zero, (sum, v) => sum + values[v]) / math.max(used.Length, 1);

    // Insects of one kind are told apart by where they are.
    private static (int, float, float, float) Order(
        (int Count, float3 Middle, float3 Normal, float4 Tint, float4 Underside) one) =>
        (one.Count, MathF.Round(one.Middle.x, 2), MathF.Round(one.Middle.y, 2), MathF.Round(one.Middle.z, 2));
}
