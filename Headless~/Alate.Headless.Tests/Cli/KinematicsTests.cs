using System;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Kinematics files: what they mean, and the one line that says what is wrong with one.</summary>
    public sealed class KinematicsTests
    {
        private const string k_Frame = "{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'all': { 'flap': FLAP } } }";

        private const string k_Start = "{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'all': { 'flap': 36, ";

        [Test]
        public void AFile_IsReadAsItIsPublished()
        {
            KinematicsFile file = Read("{ 'name': 'n', 'frequencyHz': 26.5, 'angles': 'degrees', 'waves': true, 'wings': { 'fore wing': "
                + "{ 'strokePlane': 40, 'flap': { 'mean': 0, 'harmonics': [[36, 0]] }, 'sweep': 8, 'pitch': { 'mean': 10, 'harmonics': "
                + "[[54, 89], [2, -88]] } } } }");

            PresetKinematics wing = file.Wings["fore wing"];
            Assert.That((file.Name, wing.frequency, wing.prescribed, wing.waves), Is.EqualTo(("n", 26.5f, true, true)));
            Assert.That(wing.tilt.mean, Is.EqualTo(50f));
            Assert.That(wing.sweep.mean, Is.EqualTo(8f));
            Assert.That(wing.flap.At(0.25f), Is.EqualTo(36 * Math.Cos(Math.PI / 2)).Within(1e-4));
            double pitch = 10 + 54 * Math.Cos(0.2 * Math.PI + 89 * Math.PI / 180) + 2 * Math.Cos(0.4 * Math.PI - 88 * Math.PI / 180);
            Assert.That(wing.feather.At(0.1f), Is.EqualTo(-pitch).Within(1e-4), "feather is nose down");
        }

        [Test]
        public void FeatherAndTilt_ArePitchAndStrokePlane_FromTheOtherSide()
        {
            PresetKinematics one = Read(k_Start + "'feather': -10, 'tilt': 50 } } }").Wings["all"],
                other = Read(k_Start + "'pitch': 10, 'strokePlane': 40 } } }").Wings["all"];

            Assert.That((one.feather.mean, one.tilt.mean), Is.EqualTo((-10f, 50f)));
            Assert.That((other.feather.mean, other.tilt.mean), Is.EqualTo((-10f, 50f)));
        }

        [TestCase("feather", "pitch")]
        [TestCase("tilt", "strokePlane")]
        public void TwoNamesOfOneAngle_ExcludeEachOther(string one, string other) => AssertRefused(
            k_Start + $"'{one}': 1, '{other}': 2 }} }} }}", $"wings.all: '{one}' and '{other}' exclude each other.");

        [Test]
        public void ATable_IsTheSeriesThroughIt_InRadiansToo()
        {
            string rows = string.Join(",", Enumerable.Range(0, 21).Select(
                n => FormattableString.Invariant($"[{n / 20.0},{0.5 + 0.4 * Math.Cos(2 * Math.PI * n / 20 + 0.3)}]")));

            AngleSeries flap = Read("{ 'frequencyHz': 20, 'angles': 'radians', 'wings': { 'all': { 'flap': { 'table': [" + rows
                + "] } } } }").Wings["all"].flap;

            for (float turns = 0f; turns < 1f; turns += 0.07f)
                Assert.That(flap.At(turns), Is.EqualTo((0.5 + 0.4 * Math.Cos(2 * Math.PI * turns + 0.3)) * 180 / Math.PI).Within(1e-3));
        }

        [TestCase("{ 'frequency': 20 }", "frequency: unknown key; known: name, source, frequencyHz, angles, waves, wings.")]
        [TestCase("{ 'angles': 'degrees', 'wings': {} }", "line 1: 'frequencyHz' is missing.")]
        [TestCase("{ 'frequencyHz': '20 Hz', 'angles': 'degrees', 'wings': {} }", "frequencyHz: it must be a number, not '20 Hz'.")]
        [TestCase("{ 'frequencyHz': 0, 'angles': 'degrees', 'wings': {} }", "frequencyHz: 0 is out of range: 0.1 to 1000 hertz.")]
        [TestCase("{ 'frequencyHz': 20, 'angles': 'turns', 'wings': {} }",
            "angles: 'turns' is no unit that is known: \"degrees\" or \"radians\".")]
        [TestCase(
            "{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': {} }", "wings: it must be an object with the name of each wing, or 'all'.")]
        [TestCase("{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'all': { 'sweep': 1 } } }", "wings.all: 'flap' is missing.")]
        [TestCase("{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'all': { 'flap': 1, 'phi': 2 } } }",
            "wings.all.phi: unknown key; known: flap, sweep, feather, pitch, tilt, strokePlane.")]
        [TestCase("{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'all': { 'flap': 1, 'feather': 2, 'pitch': 2 } } }",
            "wings.all: 'feather' and 'pitch' exclude each other.")]
        [TestCase("{ 'frequencyHz': 20, 'angles': 'radians', 'wings': { 'all': { 'flap': 36 } } }",
            "wings.all.flap: 2062.648° is beyond 180°; see the unit in 'angles'.")]
        [TestCase("{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'all': ", "line 1: not JSON at column 61.")]
        [TestCase("{ 'frequencyHz': 20,\n 'frequencyHz': 21 }", "line 2, frequencyHz: the key stands there twice.")]
        [TestCase("{ 'name': '\\ud800' }", "line 1, name: it is no Unicode.")]
        [TestCase("[]", "line 1: it must be a JSON object.")]
        public void ABadFile_IsOneLine(string json, string message) => AssertRefused(json, message);

        [TestCase("{ 'harmonics': [[1, 2]] }", "wings.all.flap: 'mean' is missing.")]
        [TestCase(
            "{ 'mean': 0, 'harmonics': [[1, 2, 3]] }", "wings.all.flap.harmonics[0]: it must be an amplitude and a phase, not 3 values.")]
        [TestCase("{ 'mean': 0, 'harmonics': [[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2]] }",
            "wings.all.flap.harmonics: it has 9; at most 8 are taken.")]
        [TestCase("{ 'mean': 0, 'harmonic': [[1, 2]] }", "wings.all.flap.harmonic: unknown key; known: mean, harmonics, table.")]
        [TestCase("{ 'mean': 0, 'table': [] }", "wings.all.flap: a table excludes mean and harmonics.")]
        [TestCase("{ 'table': [[0, 1], [1, 1]] }", "wings.all.flap.table: it has 2 rows; a beat needs at least four, from 0 to 1.")]
        [TestCase(
            "{ 'table': [[0, 1], [0.25, null], [0.5, 0], [0.75, 1], [1, 1]] }",
            "wings.all.flap.table[1][1]: it must be a number, not null.")]
        [TestCase("{ 'table': [[0, 1], [0.2, 3], [0.4, 0], [0.8, 1], [1, 1]] }",
            "wings.all.flap.table: there is a hole between 0.4 and 0.8; the rows must lie equally apart.")]
        [TestCase("{ 'table': [[0, 1], [0.25, 3], [0.75, 1], [1, 1]] }",
            "wings.all.flap.table: there is a hole between 0.25 and 0.75; the rows must lie equally apart.")]
        [TestCase("{ 'table': [[0, 1], [0.3, 3], [0.6, 1], [1, 1]] }",
            "wings.all.flap.table: 0 and 0.3 are not 0.3333 apart; the rows must lie equally apart.")]
        [TestCase("{ 'table': [[0, 1], [0.25, 3], [0.5, 0], [0.75, 1]] }",
            "wings.all.flap.table: it runs from 0 to 0.75; it must run from 0 to 1.")]
        [TestCase("{ 'table': [[0, 1], [0.25, 3], [0.5, 0], [0.75, 1], [1, 2]] }",
            "wings.all.flap.table: it is not periodic: 1° at 0 and 2° at 1.")]
        [TestCase("'wide'", "wings.all.flap: it must be a number, or an object with mean and harmonics, or with a table.")]
        public void ABadAngle_IsOneLine(string flap, string message) => AssertRefused(k_Frame.Replace("FLAP", flap), message);

        // Frequencies of the model, eight harmonics, half a turn, the four rows that a beat needs.
        [TestCase(0.1, "{ 'mean': -180 }")]
        [TestCase(1000, "180")]
        [TestCase(20, "{ 'mean': 0, 'harmonics': [[180,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2]] }")]
        [TestCase(20, "{ 'table': [[0, 1], [0.33333, 2], [0.66667, 0], [1, 1]] }")]
        [TestCase(20, "{ 'table': [[0, 0], [0.25095, 1], [0.5, 0], [0.75, 1], [1, 0]] }")]
        [TestCase(20, "{ 'table': [[0, 0], [0.25, 1], [0.5, 0], [0.75, 1], [1.00023, 0]] }")]
        [TestCase(20, "{ 'table': [[0, 0], [0.25, 1], [0.5, 0], [0.75, 1], [1, 0.00095]] }")]
        public void WhatIsJustWithin_IsTaken(double frequency, string flap) => Assert.That(
            Read(k_Frame.Replace("20", FormattableString.Invariant($"{frequency}")).Replace("FLAP", flap)).Frequency,
            Is.EqualTo((float)frequency));

        // A thousandth of the beat, of the step and of the range; a step of one and a half others is a hole.
        [TestCase("181", "wings.all.flap: 181° is beyond 180°; see the unit in 'angles'.")]
        [TestCase("{ 'mean': 0, 'harmonics': [[-181, 0]] }",
            "wings.all.flap.harmonics[0]: -181° is beyond 180°; see the unit in 'angles'.")]
        [TestCase("{ 'table': [[0, 1], [0.5, 3], [1, 1]] }",
            "wings.all.flap.table: it has 3 rows; a beat needs at least four, from 0 to 1.")]
        [TestCase("{ 'table': [[0, 0], [0.25106, 1], [0.5, 0], [0.75, 1], [1, 0]] }",
            "wings.all.flap.table: 0 and 0.25106 are not 0.25 apart; the rows must lie equally apart.")]
        [TestCase("{ 'table': [[0, 0], [0.25, 1], [0.5, 0], [0.75, 1], [1.00026, 0]] }",
            "wings.all.flap.table: it runs from 0 to 1.00026; it must run from 0 to 1.")]
        [TestCase("{ 'table': [[0.0001, 0], [0.25, 1], [0.5, 0], [0.75, 1], [1, 0]] }",
            "wings.all.flap.table: it runs from 0.0001 to 1; it must run from 0 to 1.")]
        [TestCase("{ 'table': [[0, 0], [0.25, 1], [0.5, 0], [0.75, 1], [1, 0.00105]] }",
            "wings.all.flap.table: it is not periodic: 0° at 0 and 0.001° at 1.")]
        [TestCase("{ 'table': [[0, 50], [0.25, 51], [0.5, 50], [0.75, 51], [1, 50.002]] }",
            "wings.all.flap.table: it is not periodic: 50° at 0 and 50.002° at 1.")]
        [TestCase("{ 'table': [[0, 0], [0.2195, 1], [0.439, 0], [0.6585, 1], [1, 0]] }",
            "wings.all.flap.table: there is a hole between 0.6585 and 1; the rows must lie equally apart.")]
        [TestCase("{ 'table': [[0, 0], [0.225, 1], [0.45, 0], [0.675, 1], [1, 0]] }",
            "wings.all.flap.table: 0 and 0.225 are not 0.25 apart; the rows must lie equally apart.")]
        public void WhatIsJustBeyond_IsRefused(string flap, string message) => AssertRefused(k_Frame.Replace("FLAP", flap), message);

        [Test]
        public void Fly_ReadsTheFile_AndTellsWhichWingsThereAre()
        {
            using var run = new CommandRun();
            string path = run.Write(
                "motion.json", "{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'third wing': { 'flap': 1 } } }".Replace('\'', '"'));

            Assert.That(run.Run("fly", "fishfly", "--kinematics", path, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors.Trim(), Is.EqualTo(
                $"alate: {path}: wings.third wing: the insect has no such wing. It has: fore wing, hind wing; 'all' is every wing."));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void AFlight_BeatsAsTheFileSays_AndTheWingThatItDoesNotNameInStep()
        {
            using var run = new CommandRun();
            const string motion =
                "{ 'frequencyHz': 20, 'angles': 'degrees', 'wings': { 'fore wing': { 'flap': { 'mean': 5, 'harmonics': [[30, 0]] } } } }";
            string path = run.Write("motion.json", motion.Replace('\'', '"'));

            FlightRecord flight = TetheredFlight.Fly(
                new FlightPlan { Species = "fishfly", KinematicsFile = path, Column = Alate.Catalogue.ComparisonColumn.RigidWing });

            foreach (RecordedWing wing in flight.Wings)
                Assert.That(wing.Frequency, Is.EqualTo(20f));
            foreach (RecordedFrame frame in flight.Wings[0].Frames)
            {
                // A turn about Z alone, by half of the flap.
                double flap = (5 + 30 * Math.Cos(frame.Phase)) * Math.PI / 180;
                Assert.That(frame.Root.value.z, Is.EqualTo(Math.Sin(0.5 * flap)).Within(1e-5));
                Assert.That(frame.Root.value.w, Is.EqualTo(Math.Cos(0.5 * flap)).Within(1e-5));
            }
        }

        [TestCase("dragonfly-flight-1")]
        [TestCase("dragonfly-flight-2")]
        [TestCase("dragonfly-flight-3")]
        [TestCase("dragonfly-tethered")]
        public void TheExamplesOfTheManual_AreKinematics(string name)
        {
            string path = Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics", name + ".json");

            KinematicsFile file = TextFile.Read(path, KinematicsJson.Read);

            Assert.That(file.Wings.Keys, Is.EqualTo(new[] { "fore wing", "hind wing" }));
            Assert.That(file.Source, Does.Contain("19").Or.Contain("20"));
        }

        private static void AssertRefused(string json, string message) =>
            Assert.That(() => Read(json), Throws.TypeOf<FormatException>()
                .With.Message.EqualTo(message.StartsWith("line ") ? message : $"line 1, {message}"));

        private static KinematicsFile Read(string json) => KinematicsJson.Read(new StringReader(json.Replace('\'', '"')));
    }
}
