using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Numbers of insects beside those of real ones, and inputs in wrong units: each is refused, marked or asked about.</summary>
    public sealed class PlausibilityTests
    {
        private const double k_Radians = Math.PI / 180;

        private const string k_OfWings = "wings.";

        private static readonly string[] s_Insects =
            ["monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "snailfish", "dragonfly"];

        private static readonly (string Key, double Factor)[] s_Mistakes =
        [
            .. new[]
            {
                "flapRangeDegrees", "featherRangeDegrees", "sweepRangeDegrees", "flapPhaseDegrees", "featherPhaseDegrees",
                "sweepPhaseDegrees", "meanFlapDegrees", "tiltDegrees", "phaseLeadDegrees", "jointLimitDegrees", "flapDegrees",
                "sweepDegrees", "featherDegrees",
            }.Select(key => (key, k_Radians)),
            .. new[] { "lengthMillimetres", "hingeMillimetres", "feetMillimetres", "centreMillimetres", "halfAxesMillimetres" }
                .SelectMany(key => new[] { (key, 1e-3), (key, 1e3) }),
            .. new[] { "massMilligrams", k_OfWings + "massMilligrams" }
                .SelectMany(key => new[] { (key, 1e-6), (key, 1e-3), (key, 1e3) }),
            ("fluidDensityKilogramsPerCubicMetre", 1e-3),
            ("flexuralStiffnessNewtonSquareMetres", 1e6), ("torsionalStiffnessNewtonSquareMetres", 1e6), ("veinWidthsMillimetres", 1e-3),
            ("veinWidthsMillimetres", 1e3),
        ];

        [Test]
        public void NumbersInWrongUnits_AreRefused_Marked_OrAskedAbout([Values("monarch", "dragonfly")] string name) =>
            Assert.That(CountFound(name), Is.GreaterThanOrEqualTo(20));

        [Test, Explicit, Category("Long")]
        public void NumbersInWrongUnits_AreRefused_Marked_OrAskedAbout_ForEveryInsect() =>
            Assert.That(s_Insects.Sum(CountFound), Is.GreaterThan(140));

        // Each key that the file says, alone, in another unit.
        private static int CountFound(string name)
        {
            using var run = new CommandRun();
            var right = JsonNode.Parse(InsectFileText.Write(InsectCatalogue.Find(name)));
            AddStiffness(right, InsectCatalogue.Find(name));
            HashSet<string> usual = Marks(run, right.ToJsonString());
            Assert.That(usual, Is.SubsetOf(GroupBound.All.Select(bound => bound.Key)), "Nothing is asked about the right file.");
            int found = 0;
            foreach ((string key, double factor) in s_Mistakes)
            {
                JsonNode wrong = right.DeepClone();
                wrong.AsObject().Remove("variants");
                // Water of 0.998 g/cm³ is as dense as air.
                if (key.StartsWith("fluidDensity") && (double)right[key] > 100)
                    continue;
                if (!Change(key.StartsWith(k_OfWings) ? wrong["wings"] : wrong, key.Split('.')[^1], factor))
                    continue;
                found++;
                TestContext.Out.Write($"{name}: {key} times {factor:G3}: ");
                try
                {
                    string[] marks = Marks(run, wrong.ToJsonString()).Except(usual).ToArray();
                    TestContext.Out.WriteLine(string.Join("; ", marks));
                    Assert.That(marks, Is.Not.Empty, $"{name}: {key} times {factor}");
                }
                catch (UserException refused)
                {
                    TestContext.Out.WriteLine(refused.Message);
                    Assert.That(refused.Message, Does.Match("line [0-9]+, .+: "), $"{name}: {key} times {factor}");
                }
            }

            return found;
        }

        // As measured, with veins of a hundredth of the length.
        private static void AddStiffness(JsonNode file, InsectDefinition insect)
        {
            foreach (WingDefinition wing in insect.Wings)
            {
                JsonNode said = file["wings"][wing.Name];
                double length = (double)said["lengthMillimetres"], each = WingStiffness.UsualOf(1e-3 * length) / wing.Chains;
                JsonArray Lists(double value) => new(Enumerable.Range(0, wing.Chains)
                    .Select(_ => (JsonNode)new JsonArray(JsonValue.Create(value), JsonValue.Create(value))).ToArray());
                said["flexuralStiffnessNewtonSquareMetres"] = Lists(each);
                said["torsionalStiffnessNewtonSquareMetres"] = Lists(each);
                said["veinWidthsMillimetres"] = Lists(0.01 * length);
            }
        }

        private static HashSet<string> Marks(CommandRun run, string text)
        {
            InsectDefinition insect = KnownSpecies.Find(run.Write("one.insect.json", text));
            var plausibility = Plausibility.Of(new FlightPlan { Definition = insect, Speed = FlightPlan.CruiseOf(insect) });
            return [.. plausibility.Outside.Select(bound => bound.Key), .. plausibility.Doubts];
        }

        // Returns true where there is a number to change.
        private static bool Change(JsonNode node, string key, double factor)
        {
            bool changed = false;
            foreach ((string name, JsonNode value) in node is JsonObject members ? members.ToList() : [])
            {
                if (name != key)
                {
                    changed |= Change(value, key, factor);
                    continue;
                }

                node[name] = Times(value, factor);
                changed |= !JsonNode.DeepEquals(node[name], value);
            }

            foreach (JsonNode item in node is JsonArray items ? items : [])
                changed |= Change(item, key, factor);
            return changed;
        }

        private static JsonNode Times(JsonNode value, double factor) => value is JsonArray items
            ? new JsonArray(items.Select(item => Times(item, factor)).ToArray())
            : JsonValue.Create(decimal.Round((decimal)((double)value * factor), 10));

        [Test]
        public void AFlapInRadians_AndAStiffnessInNewtonSquareMillimetres_AreAskedAbout_OnTheTerminalAndInTheSummary()
        {
            using var run = new CommandRun();
            string text = File.ReadAllText(Hawkmoth).Replace("\"flapRangeDegrees\": 114.6", "\"flapRangeDegrees\": 2")
                .Replace("\"massMilligrams\": 47", """
                    "massMilligrams": 47, "flexuralStiffnessNewtonSquareMetres": [[60], [30], [20], [10], [5]]
                    """).Replace("\"trims\": \"hawkmoth.trims\",", "");
            Assert.That(run.Run("fly", run.Write("wrong.insect.json", text), "--speed", "0", "--pitch", "0.7", "--no-pictures", "--out",
                run.Out), Is.Zero, run.Errors);
            using var summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json")));
            string[] doubts = summary.RootElement.GetProperty("doubts").EnumerateArray().Select(doubt => doubt.GetString()).ToArray();
            Assert.That(doubts, Has.Length.EqualTo(3));
            Assert.That(doubts[0], Does.Contain("The pitch is 0.7°: were radians meant? 0.7 rad are 40.1°"));
            Assert.That(doubts[1], Does.Contain("beat.flapRangeDegrees of the wing is 2°").And.Contain("2 rad are 114.6°"));
            Assert.That(doubts[2], Does.Contain("is the unit N m²?"));
            foreach (string doubt in doubts)
                Assert.That(run.Output, Does.Contain("? " + doubt));
            string[] outside = summary.RootElement.GetProperty("plausibility").EnumerateArray()
                .Where(group => group.GetProperty("outside").GetBoolean()).Select(group => group.GetProperty("key").GetString()).ToArray();
            Assert.That(outside, Is.SupersetOf(new[] { "flap_deg", "reduced_frequency", "ei_over_usual", "structural_over_beat" }));
            foreach (string key in outside)
                Assert.That(run.Output, Does.Contain($"† {GroupBound.All.First(bound => bound.Key == key).Title} is outside"));
        }

        [Test]
        public void APrescribedFlapInRadians_IsAskedAbout()
        {
            using var run = new CommandRun();
            string motion = run.Write("radians.json", """
                { "frequencyHz": 36, "angles": "degrees", "wings": { "fore wing": { "flap": { "mean": 0, "harmonics": [[0.52, -69]] } } } }
                """);
            int code = run.Run("fly", "dragonfly", "--kinematics", motion, "--no-pictures", "--out", run.Out);
            Assert.That(code, Is.Zero, run.Errors);
            Assert.That(run.Output, Does.Contain("? The prescribed flap of the fore wing is 1.04°: were radians meant?"));
        }

        // The file has one unit for angles and phases; a phase from another paper stands alone in it.
        [TestCase("1.5708", true)]
        [TestCase("-0.7854", true)]
        [TestCase("2.0944", true)]
        [TestCase("1.5", false)]
        [TestCase("0", false)]
        [TestCase("-69.25", false)]
        public void ASinglePhaseInRadians_IsAskedAbout(string phase, bool isAsked)
        {
            using var run = new CommandRun();
            string motion = run.Write("phase.json", $$"""
                {
                  "frequencyHz": 36, "angles": "degrees",
                  "wings": { "fore wing": { "flap": { "mean": 0, "harmonics": [[52, {{phase}}]] } } }
                }
                """);
            var flown = FlightSummary.Of(
                PlannedFlight.Fly("dragonfly", "--kinematics", motion, "--seconds", "0.1"));

            Assert.That(flown.Plausibility.Doubts.Any(doubt => doubt.StartsWith("The largest prescribed phase of the fore wing is ")),
                Is.EqualTo(isAsked));
        }

        [TestCase("--speed", "1300")]
        [TestCase("--climb", "1300")]
        [TestCase("--wind", "0,0,1300")]
        public void SpeedsInMillimetres_AreRefused(string option, string value)
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", "monarch", option, value, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Match($"{option} must lie between (0|-100) and 100; it is 1300"));
        }

        [Test]
        public void InsectsOfTheCatalogue_AreAskedAboutNothing()
        {
            foreach (InsectDefinition insect in InsectCatalogue.All)
            {
                foreach (InsectVariant variant in insect.Variants)
                {
                    var plan = new FlightPlan { Definition = insect, Variant = variant, Speed = FlightPlan.CruiseOf(insect) };
                    Assert.That(Plausibility.Of(plan).Doubts, Is.Empty, $"{insect.Name}, {variant}");
                }
            }
        }

        // Liu and Aono 2009, Bioinspir. Biomim. 4:015002, of a hovering hawkmoth: Re 6300, k 0.30, with wings of 18.3 mm mean chord.
        [Test]
        public void TheHawkmoth_HasTheGroupsOfARealOne()
        {
            InsectDefinition moth = KnownSpecies.Find(Hawkmoth);
            var plausibility = Plausibility.Of(new FlightPlan { Definition = moth, Speed = 0 });
            WingGroups wing = plausibility.Wings.Single();
            Assert.That(plausibility.Outside, Is.Empty);
            Assert.That(plausibility.Doubts, Is.Empty);
            Assert.That(wing.Reynolds, Is.EqualTo(6300).Within(15).Percent);
            Assert.That(wing.ReducedFrequency, Is.EqualTo(0.30).Within(15).Percent);
            Assert.That(wing.Strouhal, Is.NaN, "there is none in hover");
            Assert.That(wing.WingMassShare, Is.EqualTo(100 * 94.0 / 1579).Within(1e-3).Percent);
            // 8.0 sq. cm a couple, as the manual says.
            Assert.That(wing.WingLoading, Is.EqualTo(1.579e-3 * 9.81 / 16e-4).Within(2).Percent);
            Assert.That(wing.Flap, Is.EqualTo(114.6).Within(0.01));
        }

        /// <summary>A reduced frequency is π c / 2 Φ R, whatever beats how fast; the others are laws of scale.</summary>
        [Test]
        public void Groups_AreThoseOfTheirDefinitions()
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            WingGroups slow = Plausibility.Of(new FlightPlan { Definition = monarch, Speed = 1 }).Wings[0],
                fast = Plausibility.Of(new FlightPlan { Definition = monarch, Speed = 1, Frequency = 2 }).Wings[0],
                head = Plausibility.Of(new FlightPlan { Definition = monarch, Speed = 1, Wind = [0, 0, -1] }).Wings[0],
                wide = Plausibility.Of(new FlightPlan { Definition = monarch, Speed = 1, Amplitude = 0.5 }).Wings[0];
            Assert.That(fast.ReducedFrequency, Is.EqualTo(slow.ReducedFrequency).Within(1e-4).Percent);
            // Along the arc of the flap, where the Strouhal number has its chord; at 1 m/s.
            double flap = slow.Flap * k_Radians;
            Assert.That(slow.TipSpeed, Is.EqualTo(slow.Strouhal * flap / Math.Sin(flap / 2)).Within(1e-3).Percent);
            Assert.That(fast.TipSpeed, Is.EqualTo(2 * slow.TipSpeed).Within(1e-3).Percent);
            Assert.That(fast.Reynolds, Is.EqualTo(2 * slow.Reynolds).Within(1e-3).Percent);
            Assert.That(fast.StructuralRatio, Is.EqualTo(slow.StructuralRatio / 2).Within(1e-3).Percent);
            Assert.That(fast.Strouhal, Is.EqualTo(2 * slow.Strouhal).Within(1e-3).Percent);
            Assert.That(head.Strouhal, Is.EqualTo(slow.Strouhal / 2).Within(1e-3).Percent);
            Assert.That(wide.Flap, Is.EqualTo(slow.Flap / 2).Within(1e-3).Percent);
            Assert.That(wide.ReducedFrequency, Is.EqualTo(2 * slow.ReducedFrequency).Within(1e-3).Percent);
        }

        [Test]
        public void ACheck_ShowsEveryVariant_AndSaysWhatIsOutside()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("species", "firefly", "--check"), Is.Zero, run.Errors);
            Assert.That(run.Output, Does.Contain("Firefly beside real insects").And.Contain("Firefly, biological beside real insects"));
            Assert.That(run.Output, Does.Contain("† Strouhal number is outside > 0.2 (0.2 to 0.4 in cruise"));
            using var none = new CommandRun();
            Assert.That(none.Run("species", "--check"), Is.EqualTo(2));
            Assert.That(none.Errors, Does.Contain("--check needs the NAME of an insect."));
        }

        [Test]
        public void EveryRange_NamesItsSource_AndHasItsLeastBelowItsMost()
        {
            foreach (GroupBound bound in GroupBound.All)
            {
                Assert.That(bound.Source, Is.Not.Empty);
                Assert.That(bound.Low, Is.LessThan(bound.High));
            }
        }

        [TestCase(2, 180, true)]
        [TestCase(0.6109, 90, true)]
        [TestCase(-1.5708, 180, true)]
        [TestCase(-1.5708, 90, true)]
        [TestCase(0, 90, false)]
        [TestCase(1.7, 90, false, Description = "97° are not allowed")]
        [TestCase(35, 90, false)]
        [TestCase(1, 90, false)]
        public void AnglesThatMayBeRadians_AreAskedAbout(double degrees, double most, bool asked)
        {
            string doubt = most == 180 && degrees == 2 ? UnitDoubts.AboutRange("It", degrees) : UnitDoubts.AboutAngle("It", degrees, most);
            Assert.That(doubt, asked ? Does.Contain("were radians meant?") : Is.Null);
        }

        [Test]
        public void DistancesAndStiffnesses_AreAskedAbout_WhereTheyAreFarOff()
        {
            Assert.That(UnitDoubts.AboutRange("It", 0), Is.Null, "A wing that is held.");
            Assert.That(UnitDoubts.AboutDistance("It", float3.zero, 0.05), Is.Null, "The middle itself.");
            Assert.That(UnitDoubts.AboutDistance("It", new float3(3e-3f, 0f, 0f), 0.05), Is.Null);
            Assert.That(UnitDoubts.AboutDistance("It", new float3(3e-6f, 0f, 0f), 0.05),
                Does.Contain("0.003 mm").And.Contain("beside wings of 50 mm").And.Contain("metres meant"));
            Assert.That(UnitDoubts.AboutStiffness("wing", 3e-5, 1e-4), Is.Null);
            Assert.That(UnitDoubts.AboutStiffness("wing", 1e-7, 1e-4), Is.Not.Null);
            Assert.That(UnitDoubts.AboutStiffness("wing", 1e2, 1e-4), Does.Contain("1E+06"));
        }

        private static string Hawkmoth => FlownInsects.HawkmothFile;
    }
}
