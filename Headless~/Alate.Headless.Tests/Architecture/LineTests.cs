using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>The length of lines, up to which .editorconfig and CONTRIBUTING.md allow them.</summary>
    public sealed class LineTests
    {
        private const int k_Most = 140;

        [Test]
        public void Lines_AreNotLongerThanAllowed([Values("Runtime", "Editor", "Tests", "Samples~", "Headless~")] string folder)
        {
            string root = PackageRoot.Find();
            IEnumerable<string> found =
                from file in Directory.EnumerateFiles(Path.Combine(root, folder), "*.cs", SearchOption.AllDirectories)
                let place = Path.GetRelativePath(root, file).Replace('\\', '/')
                where !place.Contains("/obj/") && !place.Contains("/bin/")
                from line in TooLong(File.ReadLines(file))
                select $"{place}:{line}";

            Assert.That(found, Is.Empty);
        }

        [Test]
        public void TheEditorsLimit_IsTheSame() =>
            Assert.That(File.ReadLines(Path.Combine(PackageRoot.Find(), ".editorconfig")), Has.Member($"max_line_length = {k_Most}"));

        [Test]
        public void ALongLine_IsFoundByItsNumber() =>
            Assert.That(TooLong(["", new string('x', k_Most), new string('x', k_Most + 1)]), Is.EqualTo(new[] { "3" }));

        private static IEnumerable<string> TooLong(IEnumerable<string> lines) =>
            from line in lines.Select((text, index) => (text, index)) where line.text.Length > k_Most select $"{line.index + 1}";
    }
}
