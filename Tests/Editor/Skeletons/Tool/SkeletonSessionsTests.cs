using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonSessionsTests : SkeletonSessionFixture
    {
        [TearDown]
        public void Close() => SkeletonSessions.Close(SkeletonSessions.Current);

        [Test]
        public void OpeningASession_EndsTheOneBefore()
        {
            SkeletonSession first = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            first.Overlay.ShowsBeat = true;
            first.Place();
            Mesh shown = first.Overlay.BeatMesh;
            JointSelection selection = first.Group.Active.Selection;

            SkeletonSession second = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));

            Assert.That(SkeletonSessions.Current, Is.SameAs(second));
            Assert.That(shown == null, "the first one's mesh is destroyed");
            Assert.That(selection == null, "and its selections");
        }

        [Test]
        public void ClosingAnEarlierSession_LeavesTheLaterOne()
        {
            SkeletonSession first = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            SkeletonSession second = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));

            SkeletonSessions.Close(first);

            Assert.That(SkeletonSessions.Current, Is.SameAs(second));
        }

        [TestCase("Assets/Insects/Wings/Right.asset", "Assets/Insects/Wings")]
        [TestCase("Packages/com.alate.insect-wings/Right.asset", "Assets")]
        [TestCase("Right.asset", "Assets")]
        [TestCase("", "Assets")]
        [TestCase(null, "Assets")]
        public void NewSkeletons_GoIntoTheUsersProject(string beside, string folder) =>
            Assert.That(SkeletonFiles.FolderOf(beside), Is.EqualTo(folder));
    }
}
