using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Wrong usage of any kind gives one line, exit code 2, and writes nothing.</summary>
    public sealed class BadUsageTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [TestCase("mosquito", "mosquito", "monarch")]
        [TestCase("", "Known", "monarch")]
        public void UnknownSpecies_ListsTheKnownOnes(string species, params string[] said) =>
            AssertRefused(said, "fly", species, "--out", m_Run.Out);

        [Test]
        public void UnknownParameter_ListsTheKnownOnes() =>
            AssertRefused(new[] { "charm", "elasticity", "chord-delay", "wind" }, "sweep", "charm", "0", "1", "--out", m_Run.Out);

        [Test]
        public void NoSpecies_ListsTheKnownOnes() => AssertRefused(new[] { "monarch" }, "fly", "--out", m_Run.Out);

        [TestCase("--speed", "-1")]
        [TestCase("--speed", "NaN")]
        [TestCase("--speed", "Infinity")]
        [TestCase("--speed", "1e999")]
        [TestCase("--speed", "fast")]
        [TestCase("--climb", "inf")]
        [TestCase("--pitch", "91")]
        [TestCase("--pitch", "nan")]
        [TestCase("--seconds", "-0.5")]
        [TestCase("--seconds", "0")]
        [TestCase("--seconds", "0.01")]
        [TestCase("--lag", "-0.1")]
        [TestCase("--elasticity", "0")]
        [TestCase("--elasticity", "-1")]
        [TestCase("--elasticity", "-Infinity")]
        [TestCase("--substeps", "-24")]
        [TestCase("--substeps", "0")]
        [TestCase("--substeps", "24.5")]
        [TestCase("--substeps", "99999999999999999999")]
        [TestCase("--wind", "1,2")]
        [TestCase("--wind", "1,2,NaN")]
        [TestCase("--elements", "0")]
        [TestCase("--elements", "-3")]
        [TestCase("--elements", "some")]
        [TestCase("--coefficients", "owl")]
        [TestCase("--preset", "owl")]
        public void ValueOutOfItsRange_IsNamedWithItsOption(string option, string value) =>
            AssertRefused(new[] { option }, "fly", "monarch", option, value, "--out", m_Run.Out);

        [TestCase("--pilot", "hawk")]
        [TestCase("--to", "1,2")]
        [TestCase("--to", "NaN,0,1")]
        [TestCase("--to", "0,0,1001")]
        [TestCase("--gust", "Infinity,0,0")]
        [TestCase("--gust", "1,NaN,0")]
        [TestCase("--step", "0")]
        [TestCase("--step", "-0.02")]
        [TestCase("--step", "NaN")]
        [TestCase("--aid", "-0.1")]
        [TestCase("--aid", "1.5")]
        [TestCase("--seconds", "NaN")]
        [TestCase("--seed", "0")]
        [TestCase("--erratic", "1.1")]
        [TestCase("--erratic", "NaN")]
        [TestCase("--points", "nowhere.csv")]
        public void ValueOfAFreeFlight_OutOfItsRange_IsNamed(string option, string value) =>
            AssertRefused(new[] { option == "--points" ? value : option }, "fly", "monarch", "--free", option, value, "--out", m_Run.Out);

        [TestCase("--pilot goto", "--to")]
        [TestCase("--pilot points", "--points")]
        [TestCase("--pilot hover --to 0,0,1", "--to")]
        [TestCase("--seed 3", "wander")]
        [TestCase("--erratic 0.5", "wander")]
        public void PilotWithoutWhatItNeeds_SaysSo(string options, string said)
        {
            string[] words = options.Split(' ');
            AssertRefused(
                new[] { said }, words.Prepend("--free").Prepend("monarch").Prepend("fly").Append("--out").Append(m_Run.Out).ToArray());
        }

        [TestCase("1,2\n", "line 1")]
        [TestCase("0,0,1\n\n0,NaN,1\n", "line 3")]
        [TestCase("0,0,1\n0,far,1\n", "line 2")]
        [TestCase("0,0,2000\n", "line 1")]
        [TestCase("\n", "0 places")]
        public void PlacesThatAreNone_AreNamedWithTheirLine(string content, string said)
        {
            string file = m_Run.Write("places.csv", content);
            AssertRefused(new[] { "places.csv", said }, "fly", "monarch", "--free", "--points", file, "--out", m_Run.Out);
        }

        [Test]
        public void OptionOfAFreeFlight_WithoutFree_IsNamed() =>
            AssertRefused(new[] { "--to", "--free" }, "fly", "monarch", "--to", "0,0,1", "--out", m_Run.Out);

        [TestCase("mosquito", "--speeds", "1", "mosquito")]
        [TestCase("monarch", "--speeds", "NaN", "NaN")]
        [TestCase("monarch", "--speeds", "fast", "fast")]
        [TestCase("monarch", "--climbs", "21", "21")]
        [TestCase("monarch", "--speeds", "0,1,2,3,4,5,6,7,8,9,10,11,12", "12")]
        public void TrimOfWhatIsNone_IsNamed(string species, string option, string value, string said) =>
            AssertRefused(new[] { said }, "trim", species, option, value, "--out", m_Run.Out);

        [TestCase("fly", "monarch", "--unknown")]
        [TestCase("fly", "monarch", "moth")]
        [TestCase("fly", "monarch", "--speed")]
        [TestCase("fly", "monarch", "--no-wave", "--lag", "0.2")]
        [TestCase("fly", "monarch", "--species", "monarch")]
        [TestCase("fly", "--mesh", "wing.obj", "--species", "monarch")]
        [TestCase("new-project")]
        [TestCase("swim")]
        [TestCase("species", "mosquito")]
        [TestCase("compare")]
        [TestCase("compare", "monarch", "mosquito")]
        [TestCase("compare", "monarch", "--elasticity", "0")]
        [TestCase("compare", "monarch", "--phases", "13")]
        [TestCase("compare", "monarch", "--variant", "biological")]
        [TestCase("sweep", "elasticity", "1")]
        [TestCase("sweep", "elasticity", "one", "2")]
        [TestCase("sweep", "elasticity", "1", "NaN")]
        [TestCase("sweep", "elasticity", "1", "1")]
        [TestCase("sweep", "elasticity", "1", "2", "--steps", "1")]
        [TestCase("sweep", "elasticity", "1", "2", "--species", "mosquito")]
        [TestCase("sweep", "charm", "1", "2")]
        [TestCase("convergence", "mosquito")]
        [TestCase("convergence", "monarch", "--variant", "biological")]
        [TestCase("convergence", "monarch", "--variant", "rigid")]
        [TestCase("wind", "monarch", "mosquito")]
        [TestCase("wind", "monarch", "--variant", "biological")]
        [TestCase("wind", "monarch", "--speeds", "")]
        [TestCase("wind", "monarch", "--speeds", "1,two")]
        [TestCase("wind", "monarch", "--speeds", "1,-2")]
        [TestCase("wind", "monarch", "--speeds", "1,101")]
        [TestCase("wind", "monarch", "--speeds", "NaN")]
        [TestCase("wind", "monarch", "--speeds", "0,1,2,3,4,5,6,7,8,9,10,11,12")]
        [TestCase("figures", "nowhere")]
        public void WrongUsage_IsRefused(params string[] arguments) => AssertRefused(new string[0], arguments);

        [TestCase(null, "no such file")]
        [TestCase("", "empty")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 1 0 1\nl 1 2 3\n", "no triangles")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2\n", "line 4")]
        [TestCase("v 0 0 0\nv 1 0 zero\n", "line 2")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2 4\n", "line 4")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "area")]
        public void MissingOrBrokenMesh_IsRefused(string content, string said)
        {
            string mesh = content == null ? Path.Combine(m_Run.Folder, "none.obj") : m_Run.Write("wing.obj", content);

            AssertRefused(new[] { said }, OwnWingArguments(mesh, m_Run.Write("wing.json", OwnWing.Skeleton())));
        }

        [Test]
        public void MeshThatIsAFolder_IsRefused() =>
            AssertRefused(new[] { "folder" }, OwnWingArguments(m_Run.Folder, m_Run.Write("wing.json", OwnWing.Skeleton())));

        [Test]
        public void MeshFarFromItsSkeleton_IsRefused() => AssertRefused(
            new[] { "far away" },
            OwnWingArguments(
                m_Run.Write("wing.obj", OwnWing.Obj(new Vector3(40f, 30f, 0f))), m_Run.Write("wing.json", OwnWing.Skeleton())));

        [Test]
        public void SkeletonOfTwoChains_IsRefused() => AssertRefused(
            new[] { "2 chains" },
            OwnWingArguments(m_Run.Write("wing.obj", OwnWing.Obj()), m_Run.Write("wing.json", OwnWing.Skeleton(chains: 2))));

        [Test]
        public void SkeletonOfUnequalChains_IsRefused() => AssertRefused(
            new[] { "Chain 1" },
            OwnWingArguments(m_Run.Write("wing.obj", OwnWing.Obj()), m_Run.Write("wing.json", OwnWing.Skeleton(unequal: true))));

        [TestCase("")]
        [TestCase("{\"version\":1,")]
        [TestCase("[1,2,3]")]
        public void BrokenSkeleton_IsRefused(string content) => AssertRefused(
            new[] { "wing.json" }, OwnWingArguments(m_Run.Write("wing.obj", OwnWing.Obj()), m_Run.Write("wing.json", content)));

        [TestCase("fly", "monarch", "--out")]
        [TestCase("new-project")]
        public void FolderThatIsAFile_IsRefused(params string[] command)
        {
            string file = m_Run.Write("file", "content");

            AssertRefused(new[] { "file" }, command.Append(file).ToArray());
            Assert.That(File.ReadAllText(file), Is.EqualTo("content"));
        }

        [TestCase("fly", "monarch", "--out")]
        [TestCase("new-project")]
        public void FolderBelowAFile_IsRefused(params string[] command) =>
            AssertRefused(new[] { "file" }, command.Append(Path.Combine(m_Run.Write("file", ""), "below")).ToArray());

        [TestCase("/proc/alate")]
        [TestCase("/dev/null/alate")]
        [TestCase("")]
        public void FolderThatCannotBe_IsRefused(string folder) => AssertRefused(new[] { folder }, "fly", "monarch", "--out", folder);

        [Test]
        public void OutputThatIsAFolder_IsRefusedBeforeTheFlight()
        {
            Directory.CreateDirectory(Path.Combine(m_Run.Out, "strip.png"));

            int code = m_Run.Run("fly", "monarch", "--out", m_Run.Out);

            Assert.That(code, Is.EqualTo(2));
            Assert.That(Directory.GetFileSystemEntries(m_Run.Out), Has.Length.EqualTo(1), "nothing else was written");
        }

        private string[] OwnWingArguments(string mesh, string skeleton) =>
            new[] { "fly", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--out", m_Run.Out };

        private void AssertRefused(string[] said, params string[] arguments)
        {
            string[] before = Directory.GetFileSystemEntries(m_Run.Folder);

            int code = m_Run.Run(arguments);

            Assert.That(code, Is.EqualTo(2), m_Run.Errors);
            string[] lines = m_Run.Errors.Split('\n');
            Assert.That(lines, Has.Length.EqualTo(2), "one line: " + m_Run.Errors);
            Assert.That(lines[1], Is.Empty);
            foreach (string part in said)
                Assert.That(lines[0], Does.Contain(part).IgnoreCase);
            Assert.That(m_Run.Output, Is.Empty);
            Assert.That(Directory.GetFileSystemEntries(m_Run.Folder), Is.EquivalentTo(before), "nothing was written");
        }
    }
}
