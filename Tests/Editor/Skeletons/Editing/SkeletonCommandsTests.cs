using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonCommandsTests
    {
        [Test]
        public void Names_AreUnique() => Assert.That(SkeletonCommands.All.Select(command => command.Name), Is.Unique);

        [Test]
        public void Shortcuts_AreUnique() =>
            Assert.That(SkeletonCommands.All.Select(command => command.Shortcut).Where(shortcut => shortcut != ""), Is.Unique);

        [Test]
        public void Shortcuts_LeaveTheSceneViewItsOwn()
        {
            KeyCode[] taken =
            {
                KeyCode.Q, KeyCode.W, KeyCode.E, KeyCode.R, KeyCode.T, KeyCode.Y, KeyCode.F, KeyCode.Z, KeyCode.X, KeyCode.V,
                KeyCode.H, KeyCode.L,
            };

            Assert.That(SkeletonCommands.All.Select(command => command.Key).Intersect(taken), Is.Empty);
        }

        [Test]
        public void Keys_FindTheirCommands()
        {
            Assert.That(SkeletonCommands.Find(KeyCode.C, shift: true), Is.SameAs(SkeletonCommands.Find("Remove Chain")));
            Assert.That(SkeletonCommands.Find(KeyCode.C, shift: false), Is.SameAs(SkeletonCommands.Find("Add Chain Behind")));
            Assert.That(SkeletonCommands.Find(KeyCode.None, shift: false), Is.Null);
            Assert.That(SkeletonCommands.Find(KeyCode.F, shift: false), Is.Null);
        }

        [Test]
        public void Tooltips_AreSentences()
        {
            foreach (EditCommand command in SkeletonCommands.All)
                Assert.That(command.Tooltip, Does.Match("^[A-Z].*\\.$"), command.Name);
        }

        [Test]
        public void UnknownNames_AreNamed() =>
            Assert.That(() => SkeletonCommands.Find("Fly"), Throws.ArgumentException.With.Message.StartsWith("There is no command 'Fly'."));
    }
}
