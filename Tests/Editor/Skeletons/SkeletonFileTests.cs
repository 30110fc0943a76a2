using System.IO;
using Alate.Authoring;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonFileTests
    {
        private WingSkeleton m_Skeleton;
        private WingSkeleton m_Other;
        private string m_Path;

        [SetUp]
        public void Begin()
        {
            m_Skeleton = InsectCatalogue.Find("monarch").Wings[0].CreateSkeleton(WingSide.Right);
            m_Other = InsectCatalogue.Find("snailfish").Wings[0].CreateSkeleton(WingSide.Left);
            m_Path = Path.GetTempFileName();
        }

        [TearDown]
        public void End()
        {
            UnityEditor.Undo.ClearAll();
            Object.DestroyImmediate(m_Skeleton);
            Object.DestroyImmediate(m_Other);
            File.Delete(m_Path);
        }

        [Test]
        public void WhatIsWritten_IsReadIntoAnotherAsset_AndUndone()
        {
            string before = SkeletonJson.Write(m_Skeleton);

            Assert.That(SkeletonFile.Write(m_Other, m_Path), Is.Null);
            Assert.That(SkeletonFile.Read(m_Skeleton, m_Path, new EditorUndo()), Is.Null);
            Assert.That(SkeletonJson.Write(m_Skeleton), Is.EqualTo(SkeletonJson.Write(m_Other)));

            UnityEditor.Undo.PerformUndo();
            Assert.That(SkeletonJson.Write(m_Skeleton), Is.EqualTo(before));
        }

        [TestCase("", "1")]
        [TestCase("{\"version\":1,\"hinge\":[0,0", "1")]
        [TestCase("{\"version\":99,\"hinge\":[0,0,0],\"span\":[1,0,0],\"up\":[0,1,0],\"chains\":[]}", "99")]
        [TestCase("no JSON", "1")]
        public void ABrokenFile_ChangesNothing_AndSaysWhyInOneLine(string content, string named)
        {
            File.WriteAllText(m_Path, content);
            string before = SkeletonJson.Write(m_Skeleton);

            string refusal = SkeletonFile.Read(m_Skeleton, m_Path, new EditorUndo());

            Assert.That(refusal, Does.Contain(named).And.Not.Contain("\n"));
            Assert.That(SkeletonJson.Write(m_Skeleton), Is.EqualTo(before));
        }

        [Test]
        public void AFileThatIsNotThere_IsNamed()
        {
            string missing = Path.Combine(Path.GetTempPath(), "no such folder", "wing.json");

            Assert.That(SkeletonFile.Read(m_Skeleton, missing, new EditorUndo()), Does.Contain("wing.json"));
            Assert.That(SkeletonFile.Write(m_Skeleton, missing), Does.Contain("no such folder"));
        }

        [Test]
        public void ASkeletonWithBrokenNumbers_IsNotWritten_AndTheFileStaysAsItWas()
        {
            File.WriteAllText(m_Path, "as it was");
            m_Skeleton.Chains[1].joints[1].x = float.NaN;

            Assert.That(SkeletonFile.Write(m_Skeleton, m_Path), Is.Not.Null.And.Not.Contain("\n"));
            Assert.That(File.ReadAllText(m_Path), Is.EqualTo("as it was"));
        }
    }
}
