using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>The rooms of the package and the arrows between them: each goes one way.</summary>
    public sealed class ArrowsTests
    {
        /// <summary>[reference] Namespace of each assembly from outside the package that one of it may name.</summary>
        private static readonly Dictionary<string, string> s_Outside = new Dictionary<string, string>
        {
            ["Unity.Burst"] = "Unity.Burst",
            ["Unity.InputSystem"] = "UnityEngine.InputSystem",
            ["Unity.Mathematics"] = "Unity.Mathematics",
            ["Unity.Splines"] = "UnityEngine.Splines",
        };

        private static IEnumerable<string> Assemblies => Rooms.Assemblies.Keys;

        private static IEnumerable<string> Divided => s_Within.Keys;

        private static readonly Dictionary<string, IReadOnlyDictionary<string, string[]>> s_Within = Rooms.Within
            .Concat(CommandLineRooms.Within).ToDictionary();

        [Test]
        public void BetweenAssemblies_ThereAreOnlyTheArrowsOfTheTable() =>
            Assert.That(Rooms.BetweenAssemblies(CommandLineRooms.Assemblies), Is.Empty);

        [TestCaseSource(nameof(Divided))]
        public void BetweenRooms_ThereAreOnlyTheArrowsOfTheTable(string place) =>
            Assert.That(Rooms.BetweenRooms(place, s_Within[place]), Is.Empty);

        [Test]
        public void EveryAssemblyAndRoomThatIsDivided_IsInTheTable() => Assert.That(Rooms.Divided(), Is.EquivalentTo(Divided));

        [Test]
        public void NoRoom_LiesOnACircle()
        {
            AssertNoCircle(CommandLineRooms.Assemblies);
            foreach (IReadOnlyDictionary<string, string[]> rooms in s_Within.Values)
                AssertNoCircle(rooms);
        }

        [Test]
        public void AMissingArrow_IsToldWithFileTypeAndRule()
        {
            var rooms = new Dictionary<string, string[]>(Rooms.Within["Alate.Model"]) { ["State"] = ["Soa"] };
            var assemblies = new Dictionary<string, string[]>(Rooms.Assemblies) { ["Alate.Fitting"] = ["Alate.Model"] };

            Assert.That(
                Rooms.BetweenRooms("Alate.Model", rooms).Select(violation => violation.ToString()),
                Has.Member("Runtime/Model/State/WingPack.cs: WingPack uses RigView; there is no arrow State -> Rig"));
            var inner = new Dictionary<string, string[]>(Rooms.Within["Alate.Editor/Insects"]) { ["Presets"] = [] };
            Assert.That(
                Rooms.BetweenRooms("Alate.Editor/Insects", inner).Select(violation => violation.ToString()),
                Has.Member("Editor/Insects/Presets/PresetPanel.cs: PresetPanel uses FixOutcome; there is no arrow Presets -> Fixes"));
            Assert.That(
                Rooms.BetweenAssemblies(assemblies).Select(violation => violation.ToString()),
                Has.Member("Runtime/Fitting/FanChains.cs: FanChains uses PlanPoint; there is no arrow Alate.Fitting -> Alate.Geometry"));
        }

        [TestCase("Alate.Cli", "Flights",
            "Headless~/Alate.Cli/Flights/Free/FreeRun.cs: FreeRun uses PackageRoot; there is no arrow Flights -> Base")]
        [TestCase("Alate.Cli/Flights", "Runs",
            "Headless~/Alate.Cli/Flights/Runs/FlightRecord.cs: FlightRecord uses FlightPlan; there is no arrow Runs -> Plans")]
        [TestCase("Alate.Drawing", "Pages",
            "Headless~/Alate.Drawing/Pages/PixelPage.cs: PixelPage uses PhotoScene; there is no arrow Pages -> Photos")]
        public void AMissingArrowOfTheCommandLine_IsToldWithFileTypeAndRule(string place, string room, string told)
        {
            var rooms = new Dictionary<string, string[]>(CommandLineRooms.Within[place]) { [room] = [] };

            Assert.That(Rooms.BetweenRooms(place, rooms).Select(violation => violation.ToString()), Has.Member(told));
        }

        [Test]
        public void FormatsAndDrawing_KnowNoFlight()
        {
            var assemblies =
                new Dictionary<string, string[]>(CommandLineRooms.Assemblies) { ["Alate.Drawing"] = ["Alate.Geometry", "Alate.Model"] };

            Assert.That(
                Rooms.BetweenAssemblies(assemblies).Select(violation => violation.ToString()),
                Has.Member("Headless~/Alate.Drawing/Pages/PixelPage.cs: PixelPage uses TrueColourPng; there is no arrow Alate.Drawing "
                    + "-> Alate.Formats"));
            foreach (string assembly in new[] { "Alate.Formats", "Alate.Drawing" })
            {
                var project = XElement.Load(Path.Combine(PackageRoot.Find(), "Headless~", assembly, assembly + ".csproj"));
                IEnumerable<string> built = project.Descendants("ProjectReference")
                    .Select(reference => Path.GetFileNameWithoutExtension(reference.Attribute("Include").Value));

                Assert.That(project.Descendants("DisableTransitiveProjectReferences").Single().Value, Is.EqualTo("true"));
                Assert.That(built, Is.EquivalentTo(CommandLineRooms.Assemblies[assembly].Append("Unity")));
            }
        }

        [TestCaseSource(nameof(Assemblies))]
        [TestCase("Alate.Formats")]
        [TestCase("Alate.Drawing")]
        [TestCase("Alate.Cli")]
        public void EveryType_IsFoundInAFile(string assembly)
        {
            Dictionary<string, string> files = SourceFiles.Of(assembly);

            Assert.That(Rooms.Types(assembly).Select(type => type.Name.Split('`')[0]), Is.SubsetOf(files.Keys));
        }

        [TestCaseSource(nameof(Assemblies))]
        public void AssemblyDefinitionAndProject_SayTheSame(string assembly)
        {
            using JsonDocument definition = Definition(assembly);
            var project = XElement.Load(Path.Combine(PackageRoot.Find(), "Headless~", assembly, assembly + ".csproj"));
            IEnumerable<string> defined = definition.RootElement.GetProperty("references").EnumerateArray()
                .Select(reference => reference.GetString()).Where(Rooms.Assemblies.ContainsKey);
            IEnumerable<string> built = project.Descendants("ProjectReference")
                .Select(reference => Path.GetFileNameWithoutExtension(reference.Attribute("Include").Value))
                .Where(Rooms.Assemblies.ContainsKey);

            Assert.That(definition.RootElement.GetProperty("name").GetString(), Is.EqualTo(assembly));
            Assert.That(defined, Is.EquivalentTo(Rooms.Assemblies[assembly]));
            Assert.That(built, Is.EquivalentTo(Rooms.Assemblies[assembly]));
            Assert.That(project.Descendants("AllowUnsafeBlocks").Single().Value == "true",
                Is.EqualTo(definition.RootElement.GetProperty("allowUnsafeCode").GetBoolean()));
            Assert.That(definition.RootElement.GetProperty("allowUnsafeCode").GetBoolean(), Is.EqualTo(assembly == "Alate.Model"));
        }

        [TestCaseSource(nameof(Assemblies))]
        public void FromOutsideThePackage_AnAssemblyNamesWhatItUses(string assembly)
        {
            using JsonDocument definition = Definition(assembly);
            string root = PackageRoot.Find();
            var project = XElement.Load(Path.Combine(root, "Headless~", assembly, assembly + ".csproj"));
            IEnumerable<string> named = definition.RootElement.GetProperty("references").EnumerateArray()
                .Select(reference => reference.GetString()).Where(name => !name.StartsWith("Alate"));
            string[] sources = SourceFiles.Of(assembly).Values.Distinct()
                .Select(file => File.ReadAllText(Path.Combine(root, file))).ToArray();
            IEnumerable<string> used = s_Outside
                .Where(one => sources.Any(source => Regex.IsMatch(source, $@"^using (?:static )?{one.Value}\b", RegexOptions.Multiline)))
                .Select(one => one.Key);
            IEnumerable<string> standIns = project.Descendants("ProjectReference").Select(reference => reference.Attribute("Include").Value)
                .Where(path => path.Contains("StandIns"));

            Assert.That(named, Is.EquivalentTo(used));
            Assert.That(
                standIns.Select(Path.GetFileNameWithoutExtension),
                Is.EquivalentTo(Rooms.Folders[assembly].StartsWith("Editor") ? new[] { "Unity", "Unity.Editor" }
                    : named.Contains("Unity.InputSystem") ? new[] { "Unity", "Unity.InputSystem" } : new[] { "Unity" }));
            Assert.That(project.Descendants("DisableTransitiveProjectReferences").Single().Value, Is.EqualTo("true"));
        }

        [Test]
        public void EveryAssemblyDefinition_IsInTheTable()
        {
            string root = PackageRoot.Find();
            IEnumerable<string> there = new[] { "Runtime", "Editor" }
                .SelectMany(folder => Directory.EnumerateFiles(Path.Combine(root, folder), "*.asmdef", SearchOption.AllDirectories))
                .Select(Path.GetFileNameWithoutExtension);

            Assert.That(there, Is.EquivalentTo(Rooms.Assemblies.Keys));
        }

        [Test]
        public void AConstantOfAnotherRoom_IsSeen()
        {
            var rooms = new Dictionary<string, string[]>(Rooms.Within["Alate.Flight"]) { ["Body"] = [] };

            Assert.That(
                Rooms.BetweenRooms("Alate.Flight", rooms).Select(violation => violation.ToString()),
                Has.Member("Runtime/Flight/Body/FlightModel.cs: FlightModel uses FlightLimits; there is no arrow Body -> Commands"));
        }

        // Unity gives new scripts this namespace. An assembly whose types are all internal is judged by those.
        [TestCaseSource(nameof(Assemblies))]
        public void RootNamespace_IsThatOfTheTypes(string assembly)
        {
            using JsonDocument definition = Definition(assembly);
            Type[] types = Rooms.Types(assembly).ToArray();
            bool anyPublic = types.Any(type => type.IsPublic);
            IEnumerable<string> namespaces = types.Where(type => type.IsPublic || !anyPublic).Select(type => type.Namespace).Distinct();

            Assert.That(namespaces, Is.EqualTo(new[] { definition.RootElement.GetProperty("rootNamespace").GetString() }));
        }

        // One project builds the tests of both folders; Unity builds two assemblies, and the first is for players too.
        [TestCase("Alate.Tests", "Tests/Runtime")]
        [TestCase("Alate.Editor.Tests", "Tests/Editor")]
        public void Tests_UseOnlyWhatTheirAssemblyDefinitionNames(string assembly, string folder)
        {
            string root = Path.Combine(PackageRoot.Find(), folder);
            using var definition = JsonDocument.Parse(File.ReadAllText(Path.Combine(root, assembly + ".asmdef")));
            var known = definition.RootElement.GetProperty("references").EnumerateArray().Select(reference => reference.GetString())
                .Append(assembly).ToHashSet();
            if (definition.RootElement.GetProperty("includePlatforms").GetArrayLength() > 0)
                known.Add("UnityEditor");
            foreach (string file in Directory.EnumerateFiles(root, "*.cs", SearchOption.AllDirectories))
            {
                IEnumerable<string> used = Regex.Matches(
                    File.ReadAllText(file), @"^using (?:static |\w+ = )?((?:Alate|UnityEditor)\b[\w.]*);", RegexOptions.Multiline)
                    .Select(match => match.Groups[1].Value);
                foreach (string name in used)
                {
                    Assert.That(known.Contains(name.StartsWith("UnityEditor") ? "UnityEditor" : name),
                        $"{file} uses {name}, which {assembly}.asmdef does not name");
                }
            }
        }

        [TestCaseSource(nameof(Assemblies))]
        public void OnlyWhatStandsInEditor_IsLeftOutOfPlayers(string assembly)
        {
            using JsonDocument definition = Definition(assembly);
            string[] platforms = definition.RootElement.GetProperty("includePlatforms").EnumerateArray()
                .Select(platform => platform.GetString()).ToArray();

            Assert.That(platforms, Is.EqualTo(Rooms.Folders[assembly].StartsWith("Editor") ? new[] { "Editor" } : new string[0]));
        }

        private static JsonDocument Definition(string assembly) =>
            JsonDocument.Parse(File.ReadAllText(Path.Combine(PackageRoot.Find(), Rooms.Folders[assembly], assembly + ".asmdef")));

        private static void AssertNoCircle(IReadOnlyDictionary<string, string[]> arrows)
        {
            foreach (string room in arrows.Keys)
            {
                var reached = new HashSet<string>();
                var open = new Stack<string>(arrows[room]);
                while (open.TryPop(out string next))
                {
                    if (reached.Add(next))
                        arrows[next].ToList().ForEach(open.Push);
                }

                Assert.That(reached, Has.No.Member(room));
            }
        }
    }
}
