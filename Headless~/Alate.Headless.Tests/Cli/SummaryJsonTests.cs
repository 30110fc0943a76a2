using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    public sealed class SummaryJsonTests
    {
        private static readonly string[] s_Measured =
        {
            "frequency_hz", "twist_pp_deg", "camber_min_pct", "camber_max_pct", "tip_bend_pp_deg", "tip_bend_max_deg", "lag_deg",
            "tip_lag_deg",
            "edge_stretch_max_pct", "edge_stretch_p99_pct", "lift_over_weight", "power_w", "positive_power_w", "negative_power_w",
            "newton_iterations_mean", "resets", "us_per_substep",
        };

        [Test]
        public void EveryNumberOfTheSummary_IsThereOnce()
        {
            JsonElement summary = Parsed(Written(MonarchFlight.Level));

            foreach (string key in s_Measured)
                Assert.That(summary.GetProperty(key).ValueKind, Is.EqualTo(JsonValueKind.Number), key);
            Assert.That(summary.EnumerateObject().Select(property => property.Name), Is.Unique);
        }

        [Test]
        public void TheNumbers_AreTheMeasuredOnes()
        {
            var measured = FlightSummary.Of(MonarchFlight.Level);
            JsonElement summary = Parsed(Written(MonarchFlight.Level));

            Assert.That(summary.GetProperty("species").GetString(), Is.EqualTo("monarch"));
            Assert.That(summary.GetProperty("twist_pp_deg").GetDouble(), Is.EqualTo(measured.Main.TwistPpDeg).Within(1e-3).Percent);
            Assert.That(summary.GetProperty("camber_min_pct").GetDouble(), Is.EqualTo(measured.Main.CamberMinPct).Within(1e-3).Percent);
            double stretch = summary.GetProperty("edge_stretch_p99_pct").GetDouble();
            Assert.That(stretch, Is.EqualTo(measured.Main.EdgeStretchP99Pct).Within(1e-3).Percent);
            Assert.That(summary.GetProperty("triangles").GetInt32(), Is.EqualTo(4192), "both wings, Table 2 of the paper");
            Assert.That(summary.GetProperty("resets").GetInt32(), Is.EqualTo(0));
        }

        [Test]
        public void WhatWasAskedFor_IsToldWithIt()
        {
            var plan = new FlightPlan
            {
                Species = "monarch",
                Speed = 0.75,
                PitchDegrees = 12.5,
                Wind = new[] { 0.5, 0.0, -0.25 },
                Patches = 0,
                Column = ComparisonColumn.NoWave,
            };
            JsonElement options = Parsed(Written(MonarchFlight.Fly(plan))).GetProperty("options");

            Assert.That(options.GetProperty("speed_m_s").GetDouble(), Is.EqualTo(0.75));
            Assert.That(options.GetProperty("pitch_deg").GetDouble(), Is.EqualTo(12.5));
            Assert.That(options.GetProperty("wind_m_s").EnumerateArray().Select(component => component.GetDouble()), Is.EqualTo(plan.Wind));
            Assert.That(options.GetProperty("elements").GetString(), Is.EqualTo("triangles"));
            Assert.That(options.GetProperty("no_wave").GetBoolean(), Is.True);
        }

        [Test]
        public void WingsOfTheUsersOwn_AreToldByTheirFiles_AndByTheSpeciesWhoseNumbersTheyTake()
        {
            using var run = new CommandRun();
            var plan = new FlightPlan
            {
                Species = "fishfly",
                MeshFile = run.Write("fore.obj", OwnWing.Obj()),
                SkeletonFile = run.Write("fore.json", OwnWing.Skeleton()),
                HindMeshFile = run.Write("hind.obj", OwnWing.Obj()),
                HindSkeletonFile = run.Write("hind.json", OwnWing.Skeleton()),
                Substeps = 12,
                Patches = 64,
            };
            JsonElement summary = Parsed(Written(MonarchFlight.Fly(plan))), options = summary.GetProperty("options");

            Assert.That(summary.GetProperty("species").GetString(), Is.EqualTo("fore"));
            foreach ((string key, string value) in new[]
            {
                ("mesh", plan.MeshFile), ("skeleton", plan.SkeletonFile), ("hind_mesh", plan.HindMeshFile),
                    ("hind_skeleton", plan.HindSkeletonFile),
                ("parameters_of", "fishfly"),
            })
            {
                Assert.That(options.GetProperty(key).GetString(), Is.EqualTo(value), key);
            }
        }

        [Test]
        public void ANumberThatIsNotFinite_IsNull()
        {
            FlightRecord flight = MonarchFlight.Fly(new FlightPlan { Species = "monarch" });
            RecordedFrame last = flight.Wings[0].Frames[0];
            flight.Wings[0].Frames[0] = new RecordedFrame
            {
                Time = last.Time,
                Phase = last.Phase,
                Root = last.Root,
                Positions = last.Positions,
                Normals = last.Normals,
                Joints = last.Joints,
                Bends = last.Bends,
                AirForce = new float3(0f, float.NaN, 0f),
                NewtonIterations = last.NewtonIterations,
            };
            JsonElement summary = Parsed(Written(flight));

            Assert.That(summary.GetProperty("lift_over_weight").ValueKind, Is.EqualTo(JsonValueKind.Null));
            Assert.That(summary.GetProperty("twist_pp_deg").ValueKind, Is.EqualTo(JsonValueKind.Number));
        }

        [Test]
        public void TheTextIsIndented_AndTheSameWhateverTheCulture()
        {
            string text = Written(MonarchFlight.Level);
            using (new CommaCulture())
                Assert.That(Written(MonarchFlight.Level), Is.EqualTo(text));
            Assert.That(text, Does.StartWith("{\n  \"species\": \"monarch\",\n").And.EndsWith("}\n"));
        }

        private static JsonElement Parsed(string text) => JsonDocument.Parse(text).RootElement;

        private static string Written(FlightRecord flight)
        {
            using var stream = new MemoryStream();
            SummaryJson.Write(FlightSummary.Of(flight), stream);
            return Encoding.UTF8.GetString(stream.ToArray());
        }
    }
}
