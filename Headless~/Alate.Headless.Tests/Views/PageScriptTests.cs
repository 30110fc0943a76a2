using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Views;

/// <summary>
/// The scripts of the live view's page, run by Node with a state of the server: what they read, blend, colour and draw. Skipped where Node
/// is missing.
/// </summary>
public sealed class PageScriptTests : ViewFixture
{
    [Test]
    public void Scripts_ReadWhatTheServerSends_AndDrawLiftUpAndDragToTheRear()
    {
        WebTools.NeedPlainNode();
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.PathOf("package.json"), "{\"type\":\"module\"}");
        Fly(async () =>
        {
            string[] scripts =
                ["format.js", "overlays.js", "perch.js", "chart.js", "share.js", "stage.js", "link.js", "live.js", "dropped.js"];
            foreach (string script in scripts)
                File.WriteAllBytes(folder.PathOf(script), await Client.GetByteArrayAsync(script));
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say("{\"values\":{\"slow\":1}}");
            await page.Read("settings");
            for (int k = 0; k < 4; k++)
                await page.ReadBinary();
            byte[] state = await page.ReadBinary();
            File.WriteAllBytes(folder.PathOf("state.bin"), state);
            File.WriteAllText(folder.PathOf("state.json"), Told(new ViewState(state)));
        });
        (int code, string output) = WebTools.Run("page.mjs", folder.Root).GetAwaiter().GetResult();

        Assert.That(code, Is.Zero, output);
        Assert.That(output.Split('\n').Count(line => line.StartsWith("ok ")), Is.EqualTo(12), output);
    }

    // Insects deformed by the graphics card, lamps and a camera that is turned.
    [Test]
    public void ScriptsOfAScene_ReadWhatTheSampleSends_AndTurnItsCamera()
    {
        WebTools.NeedPlainNode();
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.PathOf("package.json"), "{\"type\":\"module\"}");
        var files = new PageFiles(ThreeSource.Public, PageKind.Scene);
        foreach (string script in new[] { "scene-format.js", "scene-look.js", "scene-share.js" })
            File.WriteAllBytes(folder.PathOf(script), files.Find(script));
        var state = new StateBuffer();
        using (var sample = new LiveSample(SampleScene.Find("garden")))
        {
            sample.Change(SampleRequest.Read("{\"look\":[5,40,-20,0.5,1,2,3]}"u8.ToArray()));
            sample.Advance(state);
            File.WriteAllText(folder.PathOf("state.json"), Told(new SampleState(state.Content.ToArray()), Camera.main.transform));
        }

        File.WriteAllBytes(folder.PathOf("state.bin"), state.Content.ToArray());
        (int code, string output) = WebTools.Run("scene-page.mjs", folder.Root).GetAwaiter().GetResult();

        Assert.That(code, Is.Zero, output);
        Assert.That(output.Split('\n').Count(line => line.StartsWith("ok ")), Is.EqualTo(5), output);
    }

    private static string Told(SampleState state, Transform eye) => JsonSerializer.Serialize(new
    {
        eye = new[] { eye.position.x, eye.position.y, eye.position.z },
        right = new[] { eye.right.x, eye.right.y, eye.right.z },
        up = new[] { eye.up.x, eye.up.y, eye.up.z },
        ahead = new[] { eye.forward.x, eye.forward.y, eye.forward.z },
        look = state.Look,
        lamps = state.Lamps.Select(lamp => lamp.Range),
        meshes = state.Meshes.Select(mesh => new
        {
            number = mesh.Number,
            sum = mesh.Places.Sum(place => (double)place.x + place.y + place.z),
            joints = mesh.Joints?.Length ?? 0,
            parts = mesh.Parts.Select(part => part.Length),
        }),
        maps = state.Maps.Select(map => new[] { (int)map.Number, map.Width, map.Height, map.Numbers.Length, map.Colours.Length }),
        draws = state.Draws.Select(draw => new
        {
            ids = new[] { (int)draw.Mesh, draw.Part, (int)draw.Picture, (int)draw.Map, (int)draw.Flags },
            shine = draw.Shine,
            underside = new[] { draw.Underside.x, draw.Underside.y, draw.Underside.z, draw.Underside.w },
            first = new[] { draw.Instances[0].x.w, draw.Instances[0].y.w, draw.Instances[0].z.w },
            tint = draw.Instances[^1].tint.x,
        }),
    });

    private static string Told(ViewState state) => JsonSerializer.Serialize(new
    {
        columns = state.Columns,
        time = state.Time,
        phase = 2.0 * System.Math.PI * (state.Beats[0] - System.Math.Floor(state.Beats[0])),
        beats = System.Math.Floor(state.Beats[0]),
        hertz = state.Hertz[0],
        lift = state.Lift[0],
        drag = state.Drag[0],
        flap = state.Flap[0],
        abdomen = state.Abdomen[0],
        substeps = state.Substeps[0],
        wakeColours = new[] { -1f, -0.25f, 0f, 0.5f, 1f }.Select(share => new
        {
            share,
            colour = new[] { WakeColours.Of(share).x, WakeColours.Of(share).y, WakeColours.Of(share).z, WakeColours.Of(share).w },
        }),
        wings = state.Wings[0].Select(wing => new
        {
            reach = wing.Reach,
            force = new[] { wing.Force.x, wing.Force.y, wing.Force.z },
            joints = wing.Joints.SelectMany(joint => new[] { joint.x, joint.y, joint.z }),
            loads = wing.Loads.SelectMany(load => new[] { load.x, load.y, load.z }),
            places = wing.Places.SelectMany(place => new[] { place.x, place.y, place.z }),
            stretch = wing.StretchPct,
            attack = wing.Attack,
        }),
    });
}
