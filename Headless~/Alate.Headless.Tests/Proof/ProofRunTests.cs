using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Versioning;
using Alate.Proof;
using Alate.Showcase;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Proof;

/// <summary>Steps of a proof as an editor runs them: import, flights, a tour of the scenes and a player.</summary>
[Platform(Exclude = "Win")]
[UnsupportedOSPlatform("windows")]
public sealed class ProofRunTests
{
    private string m_Folder, m_Before;
    private string[] m_Line;

    private string Results => Path.Combine(m_Folder, "out", "builtin");

    [SetUp]
    public void Begin()
    {
        (m_Before, m_Line) = (Environment.CurrentDirectory, ProofArguments.Line);
        m_Folder = Directory.CreateTempSubdirectory("alate-run-").FullName;
        string project = Path.Combine(m_Folder, "project");
        foreach (string sample in new[] { "B", "Garden" })
        {
            Directory.CreateDirectory(Path.Combine(project, "Assets", "Samples", sample));
            File.WriteAllText(Path.Combine(project, "Assets", "Samples", sample, sample + ".unity"), "");
            Directory.CreateDirectory(Path.Combine(m_Folder, "package", "Samples~", sample));
        }

        Directory.CreateDirectory(Results);
        Environment.CurrentDirectory = project;
        ProofArguments.Line =
        [
            "unity", ProofArguments.Out, Path.Combine(m_Folder, "out"), ProofArguments.Pipeline, "builtin", ProofArguments.Package,
            Path.Combine(m_Folder, "package"),
        ];
        RunningEditor.Scenes.Clear();
        (RunningEditor.ExitCode, RunningEditor.Seconds) = (null, 100.0);
        SetDone(false);
    }

    [TearDown]
    public void End()
    {
        foreach (SceneWitness witness in Resources.FindObjectsOfTypeAll<SceneWitness>())
            Object.DestroyImmediate(witness.gameObject);
        (Environment.CurrentDirectory, ProofArguments.Line) = (m_Before, m_Line);
        (RunningEditor.ExitCode, RunningEditor.Seconds, RunningEditor.BuildPlayer) = (null, null, null);
        EditorApplication.ExitPlaymode();
        SetDone(false);
        RunningEditor.Scenes.Clear();
        Directory.Delete(m_Folder, true);
    }

    [Test]
    public void AnImport_HoldsWhereAllSamplesAreThere_AndWritesThatAndTheMachine([Values] bool lacks)
    {
        if (lacks)
            Directory.CreateDirectory(Path.Combine(m_Folder, "package", "Samples~", "C"));
        ProofSteps.Import();
        var part = ProofPart.Read(Path.Combine(Results, "import.json"));
        Assert.That(part.lines.Select(line => (line.what, line.state)), Is.EqualTo(new[]
        {
            ("all samples import", lacks ? ProofState.Differs : ProofState.Held), ("the render pipeline is set", ProofState.Held),
        }));
        Assert.That((part.lines[0].measured, part.lines[0].allowed), Is.EqualTo(("2 scenes", lacks ? "3 scenes" : "2 scenes")));
        Assert.That((part.lines[1].measured, part.lines[1].allowed), Is.EqualTo(("built-in", "builtin")));
        Assert.That((part.step, part.pipeline, part.editor, RunningEditor.ExitCode),
            Is.EqualTo(("import", "builtin", $"Unity {Application.unityVersion}", 0)));
        Assert.That(part.machine, Does.StartWith(SystemInfo.operatingSystem));
    }

    [Test]
    public void AStepThatThrows_IsALine_AndTheEditorEndsWithOne()
    {
        UnityEngine.TestTools.LogAssert.Expect(LogType.Exception, new System.Text.RegularExpressions.Regex("golden.bin"));
        ProofSteps.Golden();
        ProofLine line = ProofPart.Read(Path.Combine(Results, "golden.json")).lines.Single();
        Assert.That((line.what, line.state, line.measured),
            Is.EqualTo(("step golden", ProofState.Differs, nameof(DirectoryNotFoundException))));
        Assert.That(line.note, Does.Contain("golden.bin"));
        Assert.That(RunningEditor.ExitCode, Is.EqualTo(1));
    }

    // The first scene writes its account and is done; the second never is, and ends after two minutes.
    [Test]
    public void ATour_PlaysEachScene_UntilItIsDone_OrItsTimeIsOver()
    {
        File.WriteAllText(Path.Combine(Results, "Garden 04 s.png"), "");
        File.WriteAllText(Path.Combine(Results, "B 01 s.png"), "");
        EditorApplication.CallbackFunction before = EditorApplication.update;
        ProofSteps.Scenes();
        var tour = (EditorApplication.CallbackFunction)Delegate.Remove(EditorApplication.update, before);
        tour();
        Assert.That((RunningEditor.Scenes.Single(), EditorApplication.isPlaying), Is.EqualTo(("Assets/Samples/B/B.unity", true)));
        SceneWitness witness = Resources.FindObjectsOfTypeAll<SceneWitness>().Single();
        Assert.That((Told<string>(witness, "m_Folder"), Told<string>(witness, "m_SceneName"), Told<float[]>(witness, "m_Times")),
            Is.EqualTo((Results, "B", SceneTour.Times)));
        tour();
        Assert.That(EditorApplication.isPlaying, Is.True, "under way");
        new SceneAccount { frames = 9, pictures = SceneTour.Times.Length }.Write(Results, "B");
        SetDone(true);
        tour();
        Assert.That(EditorApplication.isPlaying, Is.False);
        SetDone(false);
        RunningEditor.Seconds = 200.0;
        tour();
        Assert.That((RunningEditor.Scenes.Last(), EditorApplication.isPlaying), Is.EqualTo(("Assets/Samples/Garden/Garden.unity", true)));
        RunningEditor.Seconds = 319.0;
        tour();
        Assert.That(EditorApplication.isPlaying, Is.True);
        RunningEditor.Seconds = 321.0;
        tour();
        Assert.That((EditorApplication.isPlaying, RunningEditor.ExitCode), Is.EqualTo((false, default(int?))));
        tour();

        Assert.That((RunningEditor.ExitCode, RunningEditor.Scenes.Count), Is.EqualTo((0, 2)));
        Assert.That(EditorApplication.update, Is.EqualTo(before), "it is over");
        var part = ProofPart.Read(Path.Combine(Results, "scenes.json"));
        Assert.That(part.lines.Select(line => (line.what, line.state, line.measured)), Is.EqualTo(new[]
        {
            (SceneTour.Claim("B"), ProofState.Held, "9 frames of 0.0 ms, 0 errors"),
            (SceneTour.Claim("Garden"), ProofState.Differs, "no report"),
        }));
        Assert.That(part.pictures, Is.EqualTo(new[] { "builtin/B%2001%20s.png", "builtin/Garden%2004%20s.png" }));
    }

    [Test]
    public void APlayer_IsBuiltOfTheGarden_AndStarted_AndItsAccountIsRead()
    {
        File.WriteAllText(Path.Combine(Results, "Garden 04 s.png"), "");
        File.WriteAllText(Path.Combine(Results, "Player 01 s.png"), "");
        BuildPlayerOptions asked = default;
        new SceneAccount { frames = 9, pictures = SceneTour.Times.Length }.Write(m_Folder, "made");
        RunningEditor.BuildPlayer = options =>
        {
            asked = options;
            Directory.CreateDirectory(Path.GetDirectoryName(options.locationPathName));
            File.WriteAllText(options.locationPathName,
                $"#!/bin/sh\necho \"$@\" >\"{m_Folder}/arguments\"\ncp \"{m_Folder}/made.account.json\" \"$5/Player.account.json\"\n");
            File.SetUnixFileMode(options.locationPathName, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
            return 0;
        };
        ProofSteps.Player();
        var part = ProofPart.Read(Path.Combine(Results, "player.json"));
        Assert.That(part.lines.Select(line => (line.what, line.state, line.measured)), Is.EqualTo(new[]
        {
            (PlayerProof.Builds, ProofState.Held, "Succeeded, 0 errors"),
            (PlayerProof.Starts, ProofState.Held, "9 frames of 0.0 ms, 0 errors"),
        }));
        Assert.That(RunningEditor.Scenes, Is.EqualTo(new[] { "Assets/Samples/Garden/Garden.unity", "Assets/Proof Player.unity" }));
        Assert.That((asked.scenes.Single(), asked.locationPathName, asked.target),
            Is.EqualTo(("Assets/Proof Player.unity", Path.Combine(Results, "player", "Alate"), EditorUserBuildSettings.activeBuildTarget)));
        Assert.That(File.ReadAllText(Path.Combine(m_Folder, "arguments")),
            Is.EqualTo($"-batchmode -logFile {Results}/player.log -proofOut {Results}\n"));
        Assert.That(part.pictures, Is.EqualTo(new[] { "builtin/Player%2001%20s.png" }));
        SceneWitness witness = Resources.FindObjectsOfTypeAll<SceneWitness>().Single();
        Assert.That((Told<string>(witness, "m_SceneName"), Told<float[]>(witness, "m_Times")), Is.EqualTo(("Player", SceneTour.Times)));
    }

    [Test]
    public void APlayerThatIsNotBuilt_IsNotStarted()
    {
        RunningEditor.BuildPlayer = _ => 3;
        List<ProofLine> lines = [.. PlayerProof.Run(Results)];
        Assert.That(lines.Select(line => (line.what, line.state, line.measured, line.note)), Is.EqualTo(new[]
        {
            (PlayerProof.Builds, ProofState.Differs, "Failed, 3 errors", EditorUserBuildSettings.activeBuildTarget.ToString()),
            (PlayerProof.Starts, ProofState.NotTried, "", "there is no player"),
        }));
    }

    private static T Told<T>(SceneWitness witness, string field) =>
        (T)typeof(SceneWitness).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).GetValue(witness);

    private static void SetDone(bool done) => typeof(SceneWitness).GetProperty(nameof(SceneWitness.IsDone)).SetValue(null, done);
}
