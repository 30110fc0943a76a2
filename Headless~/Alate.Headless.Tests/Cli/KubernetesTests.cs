using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>
/// A study as an indexed job of Kubernetes: what its pods run and see, by the job's own command and mounts. A cluster is not at hand.
/// </summary>
public sealed class KubernetesTests
{
    private const string k_Study = """
        {
          "version": 1, "insect": "INSECT", "options": ["--speed", "0", "--pitch", "30"],
          "parameters": [{ "key": "elasticity", "from": 0.5, "to": 2, "steps": 3 }], "measures": ["lift_over_weight"]
        }
        """;

    [TestCase("moth", "moth")]
    [TestCase("It's a: Study_2", "it-s-a--study-2")]
    [TestCase("…", "study")]
    public void TheJob_HasANameThatKubernetesTakes_AndAsManyIndices(string name, string label)
    {
        using var run = new CommandRun();
        Dictionary<object, object> job = Write(run, run.Write(name + ".study.json", k_Study.Replace("INSECT", "firefly")), 6);

        Assert.That(At(job, "metadata", "name"), Is.EqualTo(label));
        Assert.That((At(job, "spec", "completionMode"), At(job, "spec", "completions")), Is.EqualTo(("Indexed", "6")));
    }

    // An insect file in a folder whose name begins as that of the study's folder does, with blanks, a colon and a quote.
    [Test]
    public void ThePodsOfAJob_SeeAllThatTheyRead_AndFlyTheStudy()
    {
        using var run = new CommandRun();
        string insects = Directory.CreateDirectory(Path.Combine(run.Folder, "it's a study: #1")).FullName,
            studies = Directory.CreateDirectory(Path.Combine(run.Folder, "it's a study")).FullName,
            insect = Path.Combine(insects, "moth.insect.json"), file = Path.Combine(studies, "moth.study.json");
        File.WriteAllText(insect, InsectFileText.Write(InsectCatalogue.Find("painted-lichen-moth")));
        File.WriteAllText(file, k_Study.Replace("INSECT", "../it's a study: #1/moth.insect.json"));
        Dictionary<object, object> job = Write(run, file, 2);

        var pod = (Dictionary<object, object>)At(job, "spec", "template", "spec");
        var container = (Dictionary<object, object>)((List<object>)pod["containers"]).Single();
        var mounts = ((List<object>)container["volumeMounts"]).Cast<Dictionary<object, object>>().ToList();
        foreach (string needed in new[] { insect, file, Path.Combine(run.Out, "rows") })
            Assert.That(mounts.Exists(mount => needed.StartsWith(mount["mountPath"] + "/", StringComparison.Ordinal)), needed);
        Assert.That(mounts.Select(mount => mount["subPath"]), Is.Unique);

        string[] command = ((List<object>)container["command"]).Cast<string>().ToArray();
        Assert.That(command[2], Does.StartWith("exec dotnet '/alate/Headless~/"));
        command[2] = command[2].Replace("'/alate/", $"'{PackageRoot.Find()}/");
        for (int index = 0; index < 2; index++)
            Assert.That(Start(command, index), Is.Empty);
        Assert.That(run.Run("study", "merge", file, run.Out, "--out", Path.Combine(run.Folder, "whole")), Is.Zero, run.Errors);
        Assert.That(File.ReadAllLines(Path.Combine(run.Folder, "whole", "study.csv")), Has.Length.EqualTo(4));
    }

    private static Dictionary<object, object> Write(CommandRun run, string file, int jobs)
    {
        Assert.That(run.Run("study", file, "--out", run.Out, "--kubernetes", $"{jobs}"), Is.Zero, run.Errors);
        return new YamlDotNet.Serialization.Deserializer().Deserialize<Dictionary<object, object>>(
            File.ReadAllText(Path.Combine(run.Out, "study.yaml")));
    }

    private static object At(object place, params string[] path) =>
        path.Aggregate(place, (at, word) => ((Dictionary<object, object>)at)[word]);

    // What a pod says on the standard error.
    private static string Start(string[] command, int index)
    {
        var start = new ProcessStartInfo(command[0], command[1..])
        {
            RedirectStandardError = true,
            RedirectStandardOutput = true,
            WorkingDirectory = Path.GetTempPath(),
        };
        start.Environment["JOB_COMPLETION_INDEX"] = $"{index}";
        using var process = Process.Start(start);
        process.OutputDataReceived += (_, _) => { };
        process.BeginOutputReadLine();
        string errors = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return errors;
    }
}
