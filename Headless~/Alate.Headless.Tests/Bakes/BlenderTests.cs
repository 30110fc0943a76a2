using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading.Tasks;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes;

/// <summary>Baked insects in Blender, without its window. Skipped where it is not installed (Debian: blender).</summary>
public sealed class BlenderTests : BakedFilesFixture
{
    private const string k_Blender = "/usr/bin/blender";

    private static string Scripts => Path.Combine(PackageRoot.Find(), "Documentation~", "blender");

    [Test, Explicit, Category("Long")]
    public void TheScriptOfTheManual_PlaysATexture([Values("monarch", "fishfly")] string species, [Values("cruise", "hover")] string clip)
    {
        string folder = Path.Combine(Files.Folder($"{species} --clips cruise,hover"), species + "_vat");
        var vat = new VatReader(folder, species);
        (int start, int end, _) = vat.Clip(clip);
        int[] frames = [0, 25, 51, 93];
        List<float3[]> shown = Places(folder, clip, frames);

        Assert.That(shown, Has.Count.EqualTo(frames.Length));
        float3[] rest = vat.At(start).Positions;
        for (int k = 0; k < frames.Length; k++)
        {
            float3[] wanted = vat.At(start + frames[k] / 100.0 * (end - start)).Positions;
            Assert.That(Farthest(shown[k], wanted), Is.LessThan(2e-5f), $"metres, frame {frames[k]}");
            Assert.That(Farthest(wanted, shown[k]), Is.LessThan(2e-5f), $"metres, frame {frames[k]}");
        }

        Assert.That(Farthest(shown[2], rest), Is.GreaterThan(5e-3f), "it beats");
    }

    [TestCase("", "--clip glide", "There is no clip 'glide' in")]
    [TestCase("", "--beats-per-second 0", "0.0 beats a second are none")]
    [TestCase("..", "", "holds 0 files *-remap_info.json")]
    [Explicit]
    [Category("Long")]
    public void WrongInput_IsOneLine(string below, string options, string told)
    {
        string folder = Path.Combine(Files.Folder("monarch --clips cruise,hover"), "monarch_vat", below);
        string[] chosen = options.Split(' ', StringSplitOptions.RemoveEmptyEntries);

        (int code, string output) = Run([Path.Combine(Scripts, "openvat.py"), "--", folder, .. chosen]).GetAwaiter().GetResult();

        Assert.That(code, Is.Not.Zero);
        Assert.That(output.Split('\n').Single(line => line.Contains(told)), Does.Not.Contain("Traceback"));
        Assert.That(output, Does.Not.Contain("Traceback"));
    }

    private static List<float3[]> Places(string folder, string clip, int[] frames)
    {
        string script = Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Bakes", "Blender", "openvat_places.py");
        IEnumerable<string> at = frames.Select(frame => frame.ToString(CultureInfo.InvariantCulture));
        (int code, string output) = Run([script, "--", Scripts, folder, clip, .. at]).GetAwaiter().GetResult();
        Assert.That(code, Is.Zero, output.Length > 2000 ? output[^2000..] : output);
        return [.. output.Split('\n').Where(line => line.StartsWith("places ")).Select(line => JsonDocument.Parse(line[7..]).RootElement
            .EnumerateArray().Select(place => new float3(place[0].GetSingle(), place[1].GetSingle(), place[2].GetSingle())).ToArray())];
    }

    private static async Task<(int Code, string Output)> Run(string[] arguments)
    {
        if (!File.Exists(k_Blender))
            Assert.Ignore("blender is not installed.");
        var start = new ProcessStartInfo(k_Blender) { RedirectStandardOutput = true, RedirectStandardError = true };
        foreach (string argument in arguments.Prepend("--python").Prepend("1").Prepend("--python-exit-code").Prepend("-b"))
            start.ArgumentList.Add(argument);
        using var process = Process.Start(start);
        Task<string> output = process.StandardOutput.ReadToEndAsync(), errors = process.StandardError.ReadToEndAsync();
        await process.WaitForExitAsync();
        return (process.ExitCode, await output + await errors);
    }

    // Blender may leave vertices out that no triangle has, and order the others in its own way.
    private static float Farthest(float3[] places, float3[] from)
    {
        float farthest = 0f;
        foreach (float3 place in places)
            farthest = math.max(farthest, from.Min(other => math.distancesq(place, other)));
        return math.sqrt(farthest);
    }
}
