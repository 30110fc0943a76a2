using System.IO;
using System.Linq;
using NUnit.Framework;
using StandIns;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>The items of a skeleton's menu that read and write JSON.</summary>
public sealed class SkeletonJsonMenuTests
{
    private const string k_Import = "CONTEXT/WingSkeleton/Import JSON…", k_Export = "CONTEXT/WingSkeleton/Export JSON…";

    private WingSkeleton m_Skeleton;
    private string m_Folder;

    [SetUp]
    public void MakeASkeleton()
    {
        m_Skeleton = TestWings.Fan();
        m_Skeleton.name = "fan";
        m_Folder = Directory.CreateTempSubdirectory("alate-json-").FullName;
    }

    [TearDown]
    public void Clear()
    {
        AnsweredDialogs.Clear();
        Object.DestroyImmediate(m_Skeleton);
        Directory.Delete(m_Folder, true);
    }

    [Test]
    public void AnExportedSkeleton_IsImportedAgain()
    {
        string file = Path.Combine(m_Folder, "own.json");
        AnsweredDialogs.Answers.Enqueue(file);
        EditorMenu.Choose(k_Export, m_Skeleton);
        Vector3[][] joints = [.. m_Skeleton.Chains.Select(chain => (Vector3[])chain.joints.Clone())];
        m_Skeleton.Chains[1].joints[2] += Vector3.up;
        AnsweredDialogs.Answers.Enqueue(file);
        EditorMenu.Choose(k_Import, m_Skeleton);

        Assert.That(AnsweredDialogs.Texts, Is.EqualTo(new[] { "Wing Skeleton: /fan.json", "Wing Skeleton: /*.json" }));
        for (int chain = 0; chain < joints.Length; chain++)
        {
            for (int joint = 0; joint < joints[chain].Length; joint++)
                Assert.That((m_Skeleton.GetJoint(chain, joint) - joints[chain][joint]).magnitude, Is.LessThan(1e-6f));
        }
    }

    [Test]
    public void WhatCannotBeReadOrWritten_IsSaid_AndCancelledSaysNothing([Values(k_Import, k_Export)] string item)
    {
        AnsweredDialogs.Answers.Enqueue("");
        EditorMenu.Choose(item, m_Skeleton);
        Assert.That(AnsweredDialogs.Texts, Has.Count.EqualTo(1));
        AnsweredDialogs.Answers.Enqueue(Path.Combine(m_Folder, "no", "such.json"));
        EditorMenu.Choose(item, m_Skeleton);
        Assert.That(AnsweredDialogs.Texts, Has.Count.EqualTo(3));
        Assert.That(AnsweredDialogs.Texts[2], Does.StartWith("Wing Skeleton: ").And.EndsWith(" [OK]").And.Contain("such.json"));
    }
}
