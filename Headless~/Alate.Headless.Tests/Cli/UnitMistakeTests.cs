using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Right numbers in wrong units, as people write them: each is refused, marked, or asked about.</summary>
    public sealed class UnitMistakeTests
    {
        // A hawkmoth of measured stiffness, with all that has a unit.
        private static readonly string s_Moth = File.ReadAllText(FlownInsects.HawkmothFile)
            .Replace("\"trims\": \"hawkmoth.trims\",", "")
            .Replace("\"rest\": { ", "\"rest\": { \"feetMillimetres\": [0, -9, 3], ")
            .Replace("\"massMilligrams\": 1579,", "\"massMilligrams\": 1579, \"fluidDensityKilogramsPerCubicMetre\": 1.225,")
            .Replace("\"massMilligrams\": 47 }", """
                "massMilligrams": 47, "hingeMillimetres": [3, 1, 2],
                "flexuralStiffnessNewtonSquareMetres": [[7e-5], [3e-5], [2e-5], [2e-5], [1e-5]],
                "torsionalStiffnessNewtonSquareMetres": [[4e-5], [2e-5], [1e-5], [1e-5], [1e-5]],
                "veinWidthsMillimetres": [[0.5], [0.4], [0.3], [0.3], [0.2]] }
                """);

        private static IEnumerable<TestCaseData> OfFiles()
        {
            yield return Mistake("metres", "\"lengthMillimetres\": 48.3", "\"lengthMillimetres\": 0.0483");
            yield return Mistake("centimetres", "\"lengthMillimetres\": 48.3", "\"lengthMillimetres\": 4.83");
            yield return Mistake("micrometres", "\"lengthMillimetres\": 48.3", "\"lengthMillimetres\": 48300");
            yield return Mistake("inches", "\"lengthMillimetres\": 48.3", "\"lengthMillimetres\": 1.9");
            yield return Mistake("grams", "\"massMilligrams\": 1579", "\"massMilligrams\": 1.579");
            yield return Mistake("kilograms", "\"massMilligrams\": 1579", "\"massMilligrams\": 0.001579");
            yield return Mistake("micrograms", "\"massMilligrams\": 1579", "\"massMilligrams\": 1579000");
            yield return Mistake("grams of a wing", "\"massMilligrams\": 47", "\"massMilligrams\": 0.047");
            yield return Mistake("kilograms of a wing", "\"massMilligrams\": 47", "\"massMilligrams\": 0.000047");
            yield return Mistake("micrograms of a wing", "\"massMilligrams\": 47", "\"massMilligrams\": 47000");
            yield return Mistake("kilohertz", "\"frequencyHertz\": 26.1", "\"frequencyHertz\": 0.0261");
            yield return Mistake("beats a minute", "\"frequencyHertz\": 26.1", "\"frequencyHertz\": 1566");
            yield return Mistake("radians a second", "\"frequencyHertz\": 26.1", "\"frequencyHertz\": 164");
            yield return Mistake("milliseconds of a beat", "\"frequencyHertz\": 26.1", "\"frequencyHertz\": 0.0383");
            yield return Mistake("kilometres an hour", "\"topSpeedMetresPerSecond\": 5", "\"topSpeedMetresPerSecond\": 18");
            yield return Mistake("centimetres a second", "\"topSpeedMetresPerSecond\": 5", "\"topSpeedMetresPerSecond\": 500");
            yield return Mistake("millimetres a second", "\"topSpeedMetresPerSecond\": 5", "\"topSpeedMetresPerSecond\": 5000");
            yield return Mistake("radians of flap", "\"flapRangeDegrees\": 114.6", "\"flapRangeDegrees\": 2");
            yield return Mistake("radians of feather", "\"featherRangeDegrees\": 100", "\"featherRangeDegrees\": 1.745");
            yield return Mistake("radians of the middle", "\"meanFlapDegrees\": 9", "\"meanFlapDegrees\": 0.157");
            yield return Mistake("radians of tilt", "\"tiltDegrees\": 35", "\"tiltDegrees\": 0.61");
            yield return Mistake("radians at rest", "\"sweepDegrees\": -70", "\"sweepDegrees\": -1.22");
            yield return Mistake("N mm²", "[[7e-5], [3e-5], [2e-5], [2e-5], [1e-5]]", "[[70], [30], [20], [20], [10]]");
            yield return Mistake("N cm²", "[[7e-5], [3e-5], [2e-5], [2e-5], [1e-5]]", "[[0.7], [0.3], [0.2], [0.2], [0.1]]");
            yield return Mistake("µN m²", "[[7e-5], [3e-5], [2e-5], [2e-5], [1e-5]]", "[[70], [30], [20], [20], [10]]");
            yield return Mistake("mN mm²", "[[7e-5], [3e-5], [2e-5], [2e-5], [1e-5]]", "[[7e4], [3e4], [2e4], [2e4], [1e4]]");
            yield return Mistake("N mm² of torsion", "[[4e-5], [2e-5], [1e-5], [1e-5], [1e-5]]", "[[40], [20], [10], [10], [10]]");
            yield return Mistake("metres of veins", "[[0.5], [0.4], [0.3], [0.3], [0.2]]", "[[5e-4], [4e-4], [3e-4], [3e-4], [2e-4]]");
            yield return Mistake("micrometres of veins", "[[0.5], [0.4], [0.3], [0.3], [0.2]]", "[[500], [400], [300], [300], [200]]");
            yield return Mistake("g/cm³", "Metre\": 1.225", "Metre\": 0.001225");
            yield return Mistake("g/m³", "Metre\": 1.225", "Metre\": 1225");
            yield return Mistake("metres of the hinge", "[3, 1, 2]", "[0.003, 0.001, 0.002]");
            yield return Mistake("micrometres of the hinge", "[3, 1, 2]", "[3000, 1000, 2000]");
            yield return Mistake("metres of the feet", "[0, -9, 3]", "[0, -0.009, 0.003]");
            yield return Mistake("micrometres of the feet", "[0, -9, 3]", "[0, -9000, 3000]");
            yield return Mistake("metres of a part", "[0, -1, -17], \"halfAxesMillimetres\": [4, 4, 14]",
                "[0, -0.001, -0.017], \"halfAxesMillimetres\": [0.004, 0.004, 0.014]");
            yield return Mistake("metres of half axes", "[4, 4, 14]", "[0.004, 0.004, 0.014]");
            yield return Mistake("centimetres of a part's place", "[0, -1, -17]", "[0, -10, -170]");
        }

        private static IEnumerable<TestCaseData> OfMotions()
        {
            const string flap = "\"harmonics\": [[36, 0]]", pitch = "\"harmonics\": [[54, 89], [2, -88], [7, 52], [1, -7]]";
            yield return Mistake("degrees as radians", "\"angles\": \"degrees\"", "\"angles\": \"radians\"");
            yield return Mistake("radians as degrees", flap, "\"harmonics\": [[0.63, 0]]");
            yield return Mistake("radians of pitch as degrees", pitch, "\"harmonics\": [[0.94, 89], [0.03, -88], [0.12, 52], [0.02, -7]]");
            yield return Mistake("phases in radians", pitch, "\"harmonics\": [[54, 1.55], [2, -1.54], [7, 0.91], [1, -0.12]]");
            yield return Mistake("kilohertz", "\"frequencyHz\": 26.5", "\"frequencyHz\": 0.0265");
            yield return Mistake("beats a minute", "\"frequencyHz\": 26.5", "\"frequencyHz\": 1590");
            yield return Mistake("radians a second", "\"frequencyHz\": 26.5", "\"frequencyHz\": 166.5");
        }

        [TestCaseSource(nameof(OfFiles))]
        public void AnInsectFile_IsRefusedOrAsked(string right, string wrong)
        {
            using var run = new CommandRun();
            string text = s_Moth.Replace(right, wrong);
            Assert.That(text, Is.Not.EqualTo(s_Moth), "there is such a number");
            Assert.That(Marks(run, s_Moth), Is.Empty, "the right file");
            AssertFound(() => Marks(run, text));
        }

        private static List<string> Marks(CommandRun run, string text)
        {
            InsectDefinition insect = KnownSpecies.Find(run.Write("moth.insect.json", text));
            var plausibility = Plausibility.Of(new FlightPlan { Definition = insect, Speed = FlightPlan.CruiseOf(insect) });
            return [.. plausibility.Outside.Select(bound => bound.Key), .. plausibility.Doubts];
        }

        [TestCaseSource(nameof(OfMotions))]
        public void AMotion_IsRefusedOrAsked(string right, string wrong)
        {
            using var run = new CommandRun();
            string text = File.ReadAllText(
                Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics", "dragonfly-flight-1.json"));
            List<string> MarksOf(string motion)
            {
                var plausibility = Plausibility.Of(new FlightPlan
                {
                    Definition = InsectCatalogue.Find("dragonfly"),
                    KinematicsFile = run.Write("motion.json", motion),
                    Speed = 0.7,
                });
                return [.. plausibility.Outside.Select(bound => bound.Key), .. plausibility.Doubts];
            }

            List<string> usual = MarksOf(text);
            Assert.That(text.Replace(right, wrong), Is.Not.EqualTo(text), "there is such a number");
            AssertFound(() => MarksOf(text.Replace(right, wrong)).Except(usual).ToList());
        }

        [Test]
        public void VeinsOfAnotherUnit_AreToldBesideTheWingsLength()
        {
            using var run = new CommandRun();
            string thick = s_Moth.Replace("[[0.5], [0.4], [0.3], [0.3], [0.2]]", "[[500], [400], [300], [300], [200]]");
            double length = 1e3 * KnownSpecies.Find(run.Write("moth.insect.json", thick)).Wings[0].Length;
            string told = string.Create(CultureInfo.InvariantCulture, $"is 500 mm wide, on a wing of {length:0.##} mm: is the unit mm?");
            Assert.That(Marks(run, thick), Has.Some.EndsWith(told));
        }

        [Test]
        public void HalfAxesOfAnotherUnit_AreToldBesideTheWingsLength()
        {
            using var run = new CommandRun();
            string large = s_Moth.Replace("[4, 4, 14]", "[400, 4, 900]");
            double length = 1e3 * KnownSpecies.Find(run.Write("moth.insect.json", large)).Wings[0].Length;
            Assert.That(Marks(run, large), Has.Some.EqualTo(string.Create(CultureInfo.InvariantCulture,
                $"A part of the body has half axes of 4 to 900 mm, beside wings of {length:0.##} mm: is the unit mm?")));
        }

        [Test]
        public void PhasesInDegrees_AmongRadians_AreAskedAbout()
        {
            using var run = new CommandRun();
            string motion = run.Write("motion.json", """
                { "frequencyHz": 26.5, "angles": "radians",
                  "wings": { "all": {
                    "flap": { "mean": 0, "harmonics": [[0.63, 0]] }, "pitch": { "mean": 0.2, "harmonics": [[0.9, 89]] } } } }
                """);
            var plan = new FlightPlan { Definition = InsectCatalogue.Find("dragonfly"), KinematicsFile = motion, Speed = 0.7 };
            Assert.That(Plausibility.Of(plan).Doubts,
                Has.Count.EqualTo(2).And.All.EndsWith("were degrees meant, where the file says radians?"));
        }

        [TestCase("--pitch", "0.61")]
        [TestCase("--speed", "150")]
        [TestCase("--speed", "5.4")]
        [TestCase("--wind", "0,0,-5400")]
        [TestCase("--climb", "-500")]
        [TestCase("--seconds", "20000")]
        [TestCase("--lag", "45")]
        [TestCase("--free", "--step", "20")]
        [TestCase("--free", "--to", "0,500,4000")]
        [TestCase("--free", "--gust", "0,-2000,0")]
        public void AnOption_IsRefusedOrAsked(params string[] words)
        {
            using var run = new CommandRun();
            int code = run.Run(["fly", "monarch", .. words, "--no-pictures", "--out", run.Out]);
            string[] lines = run.Output.Split('\n')
                .Where(line => line.StartsWith("? ") || line.StartsWith("† ") && line.Contains(" is outside ")).ToArray();
            TestContext.Out.WriteLine(code == 2 ? run.Errors : string.Join("; ", lines));
            Assert.That(code == 2 || lines.Length > 0, Is.True, run.Output);
        }

        private static void AssertFound(Func<List<string>> marks)
        {
            List<string> found;
            try
            {
                found = marks();
            }
            catch (UserException refused)
            {
                found = [refused.Message];
            }

            TestContext.Out.WriteLine(string.Join("; ", found));
            Assert.That(found, Is.Not.Empty);
        }

        private static TestCaseData Mistake(string unit, string right, string wrong) =>
            new TestCaseData(right, wrong).SetArgDisplayNames(unit, wrong);
    }
}
