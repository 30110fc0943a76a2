using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>Links, paths and type names of the manual.</summary>
    public sealed class ManualTests
    {
        private static IEnumerable<string> Pages => ManualPages.All;

        [Test]
        public void Links_LeadSomewhere([ValueSource(nameof(Pages))] string page)
        {
            IEnumerable<string> dead = ManualPages.Links(page)
                .Select(link => (Link: link, Fault: ManualPages.FindFault(page, link))).Where(link => link.Fault != null)
                .Select(link => $"{link.Link} {link.Fault}");

            Assert.That(dead, Is.Empty);
        }

        [TestCase("README.md", "Documentation~/model.md#time", null)]
        [TestCase("Documentation~/index.md", "../README.md", null)]
        [TestCase("README.md", "Documentation~/Model.md", "names no file")]
        [TestCase("README.md", "Documentation~/model.md#no-such-heading", "names no heading")]
        [TestCase("README.md", "../elsewhere.md", "leaves the package")]
        [TestCase("README.md", "http://example.org", "is no https address")]
        public void Faults_AreFound(string page, string link, string fault) =>
            Assert.That(ManualPages.FindFault(page, link), Is.EqualTo(fault));

        [Test]
        public void SourceFilesThatPagesName_Exist([ValueSource(nameof(Pages))] string page)
        {
            IEnumerable<string> paths = Regex.Matches(
                ManualPages.Text(page), @"`((?:Runtime|Editor|Tests|Headless~|Samples~|\.ci|\.github)/[\w~./-]+)")
                .Select(match => match.Groups[1].Value.TrimEnd('.', '/'))
                // What a build puts out is there after it: its project has to be.
                .Select(path => path.Split("/bin/")[0]);

            Assert.That(paths.Where(path => !ManualPages.Exists(path) && !ManualPages.Exists(path + ".cs")), Is.Empty);
        }

        [Test]
        public void EveryPage_IsOnTheIndex()
        {
            string[] linked = ManualPages.Links("Documentation~/index.md").ToArray();

            Assert.That(
                Directory.GetFiles(Path.Combine(ManualPages.Root, "Documentation~"), "*.md").Select(Path.GetFileName).Except(linked),
                Is.EqualTo(new[] { "index.md" }));
        }

        [Test]
        public void EveryPublicType_IsNamedInTheScriptingReference()
        {
            string reference = ManualPages.Text("Documentation~/scripting.md");
            var named = Regex.Matches(reference, @"`([A-Za-z.]+)`").Select(match => match.Groups[1].Value).ToHashSet();
            IEnumerable<string> names = PublicTypes().Select(type => type.IsNested ? $"{type.DeclaringType.Name}.{type.Name}" : type.Name);

            Assert.That(names.Where(name => !named.Contains(name)), Is.Empty);
        }

        // Members of types in the manual's text, such as `WingWorld.Step`.
        [Test]
        public void MembersThatPagesName_Exist([ValueSource(nameof(Pages))] string page)
        {
            if (page == "CHANGELOG.md")
                Assert.Pass("The change log names members that are gone.");

            var types = PublicTypes().Where(type => !type.IsNested).ToDictionary(type => type.Name);
            IEnumerable<string> missing = Regex.Matches(ManualPages.Text(page), @"(?<![\w.""/])([A-Z]\w+)\.([A-Z]\w+)")
                .Where(match => types.ContainsKey(match.Groups[1].Value) && match.Groups[2].Value is not ("Alate" or "Catalogue"))
                .Where(match => types[match.Groups[1].Value].GetMember(match.Groups[2].Value, BindingFlags.Public | BindingFlags.Static
                    | BindingFlags.Instance | BindingFlags.FlattenHierarchy).Length == 0)
                .Select(match => match.Value);

            Assert.That(missing, Is.Empty);
        }

        [Test]
        public void ProfilerMarkers_AreNamedOnThePageOfTheComponent()
        {
            string page = ManualPages.Text("Documentation~/insect-wings.md");
            string[] markers = Regex.Matches(ManualPages.Text("Runtime/Insects/Live/SystemMarkers.cs"), @"""Alate\.(\w+)""")
                .Select(match => match.Groups[1].Value).ToArray();

            Assert.That(markers, Is.Not.Empty);
            Assert.That(markers.Where(marker => !page.Contains($"`{marker}`") && !page.Contains($"`Alate.{marker}`")), Is.Empty);
        }

        [Test]
        public void HelpLinks_LeadToPages()
        {
            foreach (Type type in Rooms.Assemblies.Keys.SelectMany(assembly => Assembly.Load(assembly).GetTypes()))
            {
                foreach (CustomAttributeData help in type.GetCustomAttributesData()
                    .Where(data => data.AttributeType.Name == "HelpURLAttribute"))
                {
                    Assert.That(ManualPages.FindFault("package.json", (string)help.ConstructorArguments[0].Value), Is.Null, type.FullName);
                }
            }
        }

        [Test]
        public void AddressesOfThePackage_LeadSomewhere()
        {
            using var package = JsonDocument.Parse(ManualPages.Text("package.json"));
            foreach (JsonProperty property in package.RootElement.EnumerateObject()
                .Where(property => property.Name.EndsWith("Url", StringComparison.Ordinal)))
            {
                Assert.That(ManualPages.FindFault("package.json", property.Value.GetString()), Is.Null, property.Name);
            }
            foreach (JsonElement sample in package.RootElement.GetProperty("samples").EnumerateArray())
                Assert.That(ManualPages.Exists(sample.GetProperty("path").GetString()), sample.ToString());
        }

        private static IEnumerable<Type> PublicTypes() =>
            Rooms.Assemblies.Keys.SelectMany(assembly => Assembly.Load(assembly).GetExportedTypes());
    }
}
