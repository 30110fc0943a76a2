using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Alate.Cli;
using Alate.Tests.Play;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>Tests that take minutes: a plain run leaves them out, <c>.ci/long</c> finds them by their category.</summary>
    public sealed class LongTests
    {
        [Test]
        public void EachTestOfTheCategory_IsExplicit_AndNoOtherOneIs()
        {
            Assembly[] tests = [typeof(LongTests).Assembly, typeof(PlayFixture).Assembly];
            IEnumerable<MemberInfo> places = tests.SelectMany(assembly => assembly.GetTypes())
                .SelectMany(type => type.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly)
                    .Append<MemberInfo>(type));

            Assert.That(places.Where(place => IsLong(place) != IsExplicit(place)).Select(Name), Is.Empty);
            Assert.That(places.SelectMany(place => place.GetCustomAttributes<TestCaseAttribute>(), (place, test) => (place, test))
                .Where(one => one.test.Category == "Long" != one.test.Explicit).Select(one => Name(one.place)), Is.Empty);
        }

        // Both of its processes say which tests are theirs. NUnit runs no explicit test where a filter says which are not.
        [Test]
        public void EachHalfOfTheLongRun_NamesItsTests_AndTogetherTheyAreAll()
        {
            string project = File.ReadAllText(
                Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Alate.Headless.Tests.csproj"));
            string[][] halves = [.. Regex.Matches(project, "'TestCategory=Long'\">(.*)</").Select(half =>
                half.Groups[1].Value.Trim('(', ')').Split('|').Select(name => name["FullyQualifiedName~".Length..]).ToArray())];
            Assert.That(halves, Has.Length.EqualTo(2));
            Assert.That(halves.SelectMany(names => names), Has.None.Contains("!").And.None.Contains("&"));

            AreInOneEach(halves);
        }

        [Test]
        public void EachPartOfTheLongRun_NamesItsTests_AndTogetherTheyAreAll()
        {
            string[] parts = File.ReadAllLines(Path.Combine(PackageRoot.Find(), ".ci", "long-parts"));
            string[] named = ["goals", "flights", "commands", "scenes", "models"];
            Assert.That(parts.Select(part => part.Split(": ")[0]), Is.EqualTo(named));
            AreInOneEach(Array.ConvertAll(parts, part => part.Split(": ")[1].Split(' ')));
        }

        private static void AreInOneEach(string[][] parts)
        {
            string[] tests = [.. typeof(LongTests).Assembly.GetTypes().SelectMany(type => type.GetMethods().Where(test => IsLong(type)
                || IsLong(test) || test.GetCustomAttributes<TestCaseAttribute>().Any(one => one.Category == "Long"))
                .Select(test => $"{type.FullName}.{test.Name}"))];
            Assert.That(tests, Has.Length.GreaterThan(100));
            Assert.That(tests.Where(test => parts.Count(names => names.Any(test.Contains)) != 1), Is.Empty);
        }

        private static bool IsLong(MemberInfo place) =>
            place.GetCustomAttributes<CategoryAttribute>(inherit: false).Any(category => category.Name == "Long");

        private static bool IsExplicit(MemberInfo place) => place.IsDefined(typeof(ExplicitAttribute), inherit: false);

        private static string Name(MemberInfo place) => $"{place.DeclaringType?.Name}.{place.Name}";
    }
}
