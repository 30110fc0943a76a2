using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>The length of lines and the ends of files, as .editorconfig and CONTRIBUTING.md have them.</summary>
    public sealed class LineTests
    {
        private const int k_Most = 140;

        [Test]
        public void Lines_AreNotLongerThanAllowed([Values("Runtime", "Editor", "Tests", "Samples~", "Headless~")] string folder)
        {
            IEnumerable<string> found =
                from file in Sources(folder) from line in TooLong(File.ReadLines(file.path)) select $"{file.place}:{line}";

            Assert.That(found, Is.Empty);
        }

        /// <summary>The style that a build does not check.</summary>
        [Test]
        public void Files_EndWithOneLineFeed_AndHaveNoCarriageReturns(
            [Values("Runtime", "Editor", "Tests", "Samples~", "Headless~")] string folder) =>
            Assert.That(from file in Sources(folder) where !EndsWell(File.ReadAllText(file.path)) select file.place, Is.Empty);

        [TestCase("a\n", true)]
        [TestCase("a", false)]
        [TestCase("a\n\n", false)]
        [TestCase("a\r\nb\n", false)]
        public void EndsOfFiles_AreTold(string text, bool expected) => Assert.That(EndsWell(text), Is.EqualTo(expected));

        [Test]
        public void TheEditorsLimit_IsTheSame() =>
            Assert.That(File.ReadLines(Path.Combine(PackageRoot.Find(), ".editorconfig")), Has.Member($"max_line_length = {k_Most}"));

        [Test]
        public void ALongLine_IsFoundByItsNumber() =>
            Assert.That(TooLong(["", new string('x', k_Most), new string('x', k_Most + 1)]), Is.EqualTo(new[] { "3" }));

        private static IEnumerable<(string path, string place)> Sources(string folder)
        {
            string root = PackageRoot.Find();
            return from path in Directory.EnumerateFiles(Path.Combine(root, folder), "*.cs", SearchOption.AllDirectories)
                   let place = Path.GetRelativePath(root, path).Replace('\\', '/')
                   where !place.Contains("/obj/") && !place.Contains("/bin/")
                   select (path, place);
        }

        private static bool EndsWell(string text) => text.EndsWith('\n') && !text.EndsWith("\n\n") && !text.Contains('\r');

        private static IEnumerable<string> TooLong(IEnumerable<string> lines) =>
            from line in lines.Select((text, index) => (text, index)) where line.text.Length > k_Most select $"{line.index + 1}";
    }
}
