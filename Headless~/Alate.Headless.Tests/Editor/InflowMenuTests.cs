using System.IO;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>The item of a preset's menu that reads the air of a wake.</summary>
public sealed class InflowMenuTests
{
    private const string k_Read = "CONTEXT/WingPreset/Read Inflow…";

    private WingPreset m_Preset;
    private TemporaryFolder m_Folder;

    [SetUp]
    public void MakeAPreset()
    {
        m_Preset = ScriptableObject.CreateInstance<WingPreset>();
        m_Preset.name = "Dragonfly Hind Wing";
        m_Folder = new TemporaryFolder();
    }

    [TearDown]
    public void Clear()
    {
        AnsweredDialogs.Clear();
        Object.DestroyImmediate(m_Preset);
        m_Folder.Dispose();
    }

    // The series that the file tells is the one that the wing meets, in wing lengths a second.
    [Test]
    public void WhatTheCommandWrites_ComesIntoThePresetOfItsWing_AndIsUndone()
    {
        FlightRecord record = TetheredFlight.Fly(new FlightPlan { Species = "dragonfly", Speed = 1.0, Substeps = 24 });
        using var wake = new WakeFlight(record, new WakePlan { Beats = 1, StepsPerBeat = 12, SpanPanels = 4 });
        FlightInflow found = WakeRounds.InflowOf(wake, wake.Run(_ => { }));
        string path = m_Folder.PathOf("inflow.json");
        using (FileStream stream = File.Create(path))
            InflowJson.Write(wake, found, stream);
        WingInflow hind = found.Wings[("hind wing", WingSide.Right)];

        Undo.IncrementCurrentGroup();
        Read(path);
        Assert.That(AnsweredDialogs.Texts, Has.Count.EqualTo(1), "the question alone");
        PresetInflow read = m_Preset.Inflow;
        foreach ((Vector3 one, float3 other) in new[]
        {
            (read.mean, hind.mean), (read.cosine1, hind.cosine1), (read.sine1, hind.sine1), (read.cosine2, hind.cosine2),
            (read.sine2, hind.sine2),
        })
        {
            Assert.That(math.distance(one, other), Is.LessThan(2e-5f));
            Assert.That(math.length(other), Is.GreaterThan(1e-3f));
        }

        Undo.PerformUndo();
        Assert.That(m_Preset.Inflow.mean, Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void OneKindOfWing_GoesIntoAnyPreset()
    {
        m_Preset.name = "mine";
        Read(Write("right wing", "1,-2,3"));

        Assert.That(m_Preset.Inflow.mean, Is.EqualTo(new Vector3(1f, -2f, 3f)));
        Assert.That(m_Preset.Inflow.sine2, Is.EqualTo(new Vector3(0.5f, 0f, 0f)));
    }

    [TestCase("wing", "right fore wing", "1,2,3", "rename the preset 'wing'")]
    [TestCase("hind wing", "right wing", "1,2", "missing or not within ±100 m/s")]
    [TestCase("hind wing", "right wing", "1,2,101", "missing or not within ±100 m/s")]
    [TestCase("hind wing", "left wing", "1,2,3", "holds left wing")]
    public void WhatDoesNotFit_IsSaidInOneLine_AndChangesNothing(string preset, string wing, string mean, string said)
    {
        m_Preset.name = preset;
        Read(Write(wing, mean, preset == "wing" ? "right hind wing" : null));

        AssertRefused(said);
    }

    [TestCase("{", "JSON")]
    [TestCase("{}", "is no inflow of version 1")]
    [TestCase("{\"version\":2,\"wings\":[]}", "is no inflow of version 1")]
    [TestCase("{\"version\":1,\"wings\":[null]}", "is no inflow of version 1")]
    [TestCase("{\"version\":1,\"wings\":[{\"wing\":null}]}", "is no inflow of version 1")]
    [TestCase("{\"version\":1,\"wings\":[{},{},{},{},{},{},{},{},{}]}", "is no inflow of version 1")]
    [TestCase("{\"version\":1,\"wings\":[{\"wing\":\"right 0123456789012345678901234567890123456789012345678901234567890\"}]}",
        "is no inflow of version 1")]
    public void WhatIsNoInflow_IsSaidInOneLine_AndChangesNothing(string text, string said)
    {
        string path = m_Folder.PathOf("inflow.json");
        File.WriteAllText(path, text);
        Read(path);

        AssertRefused(said);
    }

    [Test]
    public void AFileThatIsNotThere_IsSaid_AndACancelledQuestionSaysNothing()
    {
        Read(m_Folder.PathOf("no.json"));
        AssertRefused("no.json");
        Read("");
        Assert.That(AnsweredDialogs.Texts, Has.Count.EqualTo(3));
        using (FileStream stream = File.Create(m_Folder.PathOf("large.json")))
            stream.SetLength(2 << 20);
        Read(m_Folder.PathOf("large.json"));
        Assert.That(AnsweredDialogs.Texts[^1], Does.Contain("larger than any inflow"));
    }

    private void Read(string path)
    {
        AnsweredDialogs.Answers.Enqueue(path);
        EditorMenu.Choose(k_Read, m_Preset);
    }

    private void AssertRefused(string said)
    {
        Assert.That(AnsweredDialogs.Texts, Has.Count.EqualTo(2));
        Assert.That(AnsweredDialogs.Texts[1], Does.StartWith("Wing Preset: ").And.EndsWith(" [OK]").And.Contain(said));
        Assert.That(AnsweredDialogs.Texts[1], Does.Not.Contain("\n"));
        Assert.That(m_Preset.Inflow.mean, Is.EqualTo(Vector3.zero));
    }

    private string Write(string wing, string mean, string other = null)
    {
        string Entry(string name) => $"{{\"wing\":\"{name}\",\"mean_m_s\":[{mean}],\"cosine_1_m_s\":[0,0,0],"
            + "\"sine_1_m_s\":[0,0,0],\"cosine_2_m_s\":[0,0,0],\"sine_2_m_s\":[0.5,0,0]}";
        string path = m_Folder.PathOf("inflow.json");
        File.WriteAllText(
            path, $"{{\"version\":1,\"wings\":[{Entry(wing)}{(other == null ? "" : "," + Entry(other))}]}}");
        return path;
    }
}
