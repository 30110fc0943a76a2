using System.IO;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>The command <c>skeleton fit</c>.</summary>
    public sealed class SkeletonFitTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Mesh_GetsAValidSkeletonAndAPicture()
        {
            string mesh = m_Run.Write("wing.obj", OwnWing.Obj());

            int code = m_Run.Run("skeleton", "fit", mesh, "--chains", "6", "--joints", "4", "--hinge", "0,0,0", "--out", m_Run.Out);

            Assert.That(code, Is.Zero, m_Run.Errors);
            WingSkeleton skeleton = SkeletonJson.Read(File.ReadAllText(Path.Combine(m_Run.Out, "skeleton.json")));
            Assert.That(skeleton.Validate(), Is.Empty);
            Assert.That((skeleton.ChainCount, skeleton.JointsPerChain), Is.EqualTo((6, 4)));
            Assert.That(skeleton.Hinge, Is.EqualTo(Vector3.zero));
            Assert.That(File.ReadAllText(Path.Combine(m_Run.Out, "skeleton.svg")), Does.StartWith("<svg"));
            Assert.That(m_Run.Output, Does.Contain("6 chains of 4 joints, confidence 1.00.")
                .And.Contain($"Wrote skeleton.json and skeleton.svg into {m_Run.Out}."));
        }

        [Test]
        public void WhatWasGuessed_IsSaid()
        {
            string mesh = m_Run.Write("wing.obj", OwnWing.Obj());

            m_Run.Run("skeleton", "fit", mesh, "--out", m_Run.Out);

            Assert.That(m_Run.Output, Does.Contain("HingeGuessed"));
        }

        [TestCase("", "is empty")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 0 0 1\n", "no triangles")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", "single triangle")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 9\n", "no vertex 9")]
        [TestCase("hello", "no vertex")]
        public void FileThatIsNoWing_IsRefused(string content, string said) => AssertRefused(m_Run.Write("wing.obj", content), said);

        [Test]
        public void TwoWings_AreRefused()
        {
            string one = OwnWing.Obj(), other = OwnWing.Obj(new Vector3(3f, 0f, 0f));
            int count = one.Split("\nv ").Length - 1;
            string shifted = System.Text.RegularExpressions.Regex.Replace(
                other, @"(?m)^f (\d+) (\d+) (\d+)", m => $"f {int.Parse(m.Groups[1].Value) + count} "
                    + $"{int.Parse(m.Groups[2].Value) + count} {int.Parse(m.Groups[3].Value) + count}");

            AssertRefused(m_Run.Write("wings.obj", one + shifted), "fit each wing by itself");
        }

        [Test]
        public void MissingFile_IsRefused() => AssertRefused(Path.Combine(m_Run.Folder, "none.obj"), "no such file");

        [TestCase("--chains", "2")]
        [TestCase("--joints", "17")]
        [TestCase("--hinge", "1,2")]
        [TestCase("--body", "a,b,c")]
        [TestCase("--forward", "0,0,0")]
        [TestCase("--up", "nan,0,1")]
        public void ValueOutOfItsRange_IsNamed(string option, string value) =>
            AssertRefused(m_Run.Write("wing.obj", OwnWing.Obj()), option.TrimStart('-'), option, value);

        private void AssertRefused(string mesh, string said, params string[] options)
        {
            int code = m_Run.Run(["skeleton", "fit", mesh, "--out", m_Run.Out, .. options]);

            Assert.That(code, Is.EqualTo(2), m_Run.Errors);
            Assert.That(m_Run.Errors.Split('\n'), Has.Length.EqualTo(2), "one line: " + m_Run.Errors);
            Assert.That(m_Run.Errors, Does.Contain(said));
            Assert.That(m_Run.Output, Is.Empty);
            Assert.That(Directory.Exists(m_Run.Out), Is.False, "nothing was written");
        }
    }
}
