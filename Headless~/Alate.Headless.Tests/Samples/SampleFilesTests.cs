using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using Alate.Samples;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Samples;

/// <summary>Files of each sample that the Package Manager imports.</summary>
public sealed class SampleFilesTests
{
    private static string Root => Path.GetFullPath(Path.Combine(AppContext.BaseDirectory, "../../../../.."));

    private static IEnumerable<string> Samples()
    {
        using var package = JsonDocument.Parse(File.ReadAllText(Path.Combine(Root, "package.json")));
        return [.. package.RootElement.GetProperty("samples").EnumerateArray().Select(sample => sample.GetProperty("path").GetString())];
    }

    [Test]
    public void EverySampleFolder_IsListed()
    {
        IEnumerable<string> folders = Directory.GetDirectories(Path.Combine(Root, "Samples~"))
            .Select(folder => "Samples~/" + Path.GetFileName(folder));
        Assert.That(Samples(), Is.EquivalentTo(folders));
    }

    [TestCaseSource(nameof(Samples))]
    public void EverySample_HasAReadme_AnAssembly_AndASceneWithItsScript(string path)
    {
        string folder = Path.Combine(Root, path);
        Assert.That(File.Exists(Path.Combine(folder, "README.md")), Is.True);
        string scene = File.ReadAllText(Directory.GetFiles(folder, "*.unity").Single());
        string script = Regex.Match(scene, @"m_Script: \{fileID: 11500000, guid: (\w+), type: 3\}").Groups[1].Value;
        string meta = Directory.GetFiles(folder, "*.cs.meta").Single(file => File.ReadAllText(file).Contains(script));
        string name = Path.GetFileName(meta).Replace(".cs.meta", "");
        Type type = typeof(MonarchSample).Assembly.GetType("Alate.Samples." + name);
        Assert.That(typeof(MonoBehaviour).IsAssignableFrom(type), Is.True, $"{name} is no script for an object");
        Assert.That(File.ReadAllText(Path.Combine(folder, "README.md")),
            Does.Contain(Path.GetFileName(Directory.GetFiles(folder, "*.unity").Single())));
    }

    [TestCaseSource(nameof(Samples))]
    public void EveryScene_HasWhatUnityWrites_AndOneAudioListener(string path)
    {
        string scene = File.ReadAllText(Directory.GetFiles(Path.Combine(Root, path), "*.unity").Single());
        Assert.That(scene, Does.Match(@"\nOcclusionCullingSettings:\n(?:  .*\n)*?  m_SceneGUID: 0{32}\n"));
        Assert.That(
            Regex.Matches(scene, @"--- !u!81 &\d+\nAudioListener:"), Has.Count.EqualTo(1), "Unity warns of a scene without a listener");

        // Components are listed by their object, and belong to it.
        string[] listed = [.. Regex.Matches(scene, @"- component: \{fileID: (\d+)\}").Select(match => match.Groups[1].Value)];
        string[] owned = [.. Regex.Matches(scene, @"--- !u!\d+ &(\d+)\n\w+:\n(?:  .*\n)*?  m_GameObject:")
            .Select(match => match.Groups[1].Value)];
        Assert.That(owned, Is.EqualTo(listed));
    }

    [Test]
    public void NoLinkOfThePackage_LeadsNowhere()
    {
        string[] folders = ["Runtime", "Editor", "Samples~"];
        IEnumerable<string> files = folders
            .SelectMany(folder => Directory.GetFiles(Path.Combine(Root, folder), "*.cs", SearchOption.AllDirectories))
            .Append(Path.Combine(Root, "package.json"));
        Assert.That(
            files.Where(file => Regex.IsMatch(File.ReadAllText(file), @"https?://[^/""]*(example\.|\.invalid|localhost)")), Is.Empty);
    }

    [TestCaseSource(nameof(Samples))]
    public void EverySample_StandsAlone_WithThePackage(string path)
    {
        string folder = Path.Combine(Root, path);
        string own = TextOf(folder);
        using var assembly = JsonDocument.Parse(File.ReadAllText(Directory.GetFiles(folder, "*.asmdef").Single()));
        Assert.That(
            assembly.RootElement.GetProperty("references").EnumerateArray().Select(name => name.GetString()),
            Is.EqualTo(References(own)));

        // All samples are one assembly here: what a file uses must be declared in its own folder.
        foreach (string other in Samples().Where(other => other != path))
        {
            foreach (Match declared in Regex.Matches(TextOf(Path.Combine(Root, other)), @"\b(?:class|struct) (\w+)"))
            {
                string name = declared.Groups[1].Value;
                Assert.That(Regex.IsMatch(own, $@"\b(new {name}\b|{name}\.\w)"), Is.False, $"{path} uses {name} of {other}");
            }
        }
    }

    // The assemblies of flight, crowds and mathematics only where the sample uses them.
    private static IEnumerable<string> References(string text)
    {
        string[] always = ["Alate", "Alate.Catalogue", "Alate.Fitting", "Alate.Model"],
            chosen = ["Alate.Crowds", "Alate.Flight", "Alate.Showcase", "Unity.Mathematics"];
        return always.Concat(chosen.Where(assembly => text.Contains($"using {assembly};"))).Order(StringComparer.Ordinal);
    }

    private static string TextOf(string folder) =>
        string.Concat(Directory.GetFiles(folder, "*.cs", SearchOption.AllDirectories).Select(File.ReadAllText));
}
