using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>Rules of prose that a machine can hold; CONTRIBUTING.md has them all.</summary>
    public sealed class ProseTests
    {
        private static readonly Regex s_Start = new Regex(
            @"<summary>\s*(?:///\s*)?(?:\[[^\]]*\]\s*)*(What|Who|It|How|Where|Whether|That|Whose|If|Nobody|Somebody|Something)\b");

        [Test]
        public void Summaries_StartWithANounOrAVerb([Values("Runtime", "Editor", "Tests", "Samples~", "Headless~")] string folder)
        {
            string root = PackageRoot.Find();
            IEnumerable<string> found =
                from file in Directory.EnumerateFiles(Path.Combine(root, folder), "*.cs", SearchOption.AllDirectories)
                let place = Path.GetRelativePath(root, file).Replace('\\', '/')
                where !place.Contains("/obj/") && !place.Contains("/bin/")
                from Match start in s_Start.Matches(File.ReadAllText(file))
                select $"{place}: {start.Groups[1].Value}";

            Assert.That(found, Is.Empty);
        }

        [TestCase("/// <" + "summary>What the insect does.</summary>", true)]
        [TestCase("/// <" + "summary>\n    /// [wing] Whether it beats.", true)]
        [TestCase("/// <summary>Wheel of the cart.</summary>", false)]
        public void ARule_IsFoundBroken(string line, bool broken) => Assert.That(s_Start.IsMatch(line), Is.EqualTo(broken));
    }
}
