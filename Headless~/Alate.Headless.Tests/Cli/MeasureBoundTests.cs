using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Numbers beside what is usual on real insects, and the map of the stretch.</summary>
    public sealed class MeasureBoundTests
    {
        private static readonly WingSummary s_Usual = new WingSummary("wing", 10, 20, -3, 4, 10, 8, 20, 10, 2, 1);

        [Test]
        public void UsualNumbers_AreNotMarked() =>
            Assert.That(MeasureBound.All.Select(bound => bound.Cell(s_Usual, InsectVariant.Standard)), Is.All.Not.Contains("†"));

        [Test]
        public void NumbersOutside_AreMarked_EachByItsOwnRange()
        {
            var odd = new WingSummary("wing", 10, 60, -20, 4, 90, 47, 5, 10, 7, 1);

            Assert.That(MeasureBound.All.Select(bound => bound.Cell(odd, InsectVariant.Standard)), Is.All.Contains("†"));
            Assert.That(
                MeasureBound.Find("edge_stretch_max_pct").Holds(odd, InsectVariant.Expressive), Is.True, "soft wings may stretch by 8 %");
        }

        [Test]
        public void EveryRange_NamesItsSource() => Assert.That(MeasureBound.All.Select(bound => bound.Source), Is.All.Not.Empty);

        [Test]
        public void TerminalAndSummary_SayWhatIsOutside()
        {
            var summary = FlightSummary.Of(MonarchFlight.Fly(new FlightPlan { Species = "monarch", Elasticity = 0.02 }));
            using var stream = new MemoryStream();
            SummaryJson.Write(summary, stream);
            using var terminal = new StringWriter();
            new Terminal(terminal).ShowSummary(summary, "out");
            string[] outside = JsonDocument.Parse(stream.ToArray()).RootElement.GetProperty("outside_usual").EnumerateArray()
                .Select(key => key.GetString()).ToArray();

            Assert.That(outside, Is.Not.Empty.And.SubsetOf(MeasureBound.All.Select(bound => bound.Key)));
            foreach (string key in outside)
                Assert.That(terminal.ToString(), Does.Contain($"† {MeasureBound.Find(key).Title} is outside the usual"));
            Assert.That(terminal.ToString(), Does.Contain("usual").And.Contain("10–50"));
        }

        // The same looks once as a wing's own and once as numbers: these have no shadows.
        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void WingsThatShowNumbers_HaveNoShadows()
        {
            Color32[] Painted(PhotoScene scene) => [.. new[] { 0.0, 0.25, 0.5, 0.75 }.Select(turns => scene.PoseAt(turns))
                .SelectMany(pose => scene.Draw(pose, StripPanel.Around(pose, 480f, 4f), 1f))];

            Color32[] own = Painted(FlightPhoto.Scene(MonarchFlight.Level)),
                numbers = Painted(FlightPhoto.Scene(MonarchFlight.Level, surfaceOf: FlightPhoto.Surface));
            int[] lighter = [.. numbers.Zip(own, (plain, shaded) => plain.r + plain.g + plain.b - shaded.r - shaded.g - shaded.b)];
            Assert.That(lighter.Min(), Is.GreaterThanOrEqualTo(0), "a shadow lights nothing");
            Assert.That(lighter.Count(difference => difference > 8), Is.GreaterThan(50), "pixels in a shadow");
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void StretchMap_IsPaleWhereNothingStretches_AndDarkWhereItDoes()
        {
            var picture = PngFile.Read(StretchMap.Draw(MonarchFlight.Level));

            Assert.That(picture.Pixels.Count(pixel => pixel.r > 200 && pixel.g > 150 && pixel.b is > 30 and < 190), Is.GreaterThan(300),
                "yellow where it stretches a little");
        }

        [Test]
        public void StretchField_HasTheLargestStretchOfTheSummary()
        {
            RecordedWing wing = MonarchFlight.Level.Wings[0];

            Assert.That(100f * StretchField.Largest(wing).Max(), Is.EqualTo(WingSummary.Of(wing).EdgeStretchMaxPct).Within(1e-3));
        }

        [Test]
        public void StretchField_IsTheStretchOfTheEdges()
        {
            var wing = new RecordedWing
            {
                Rest = new[] { new float3(0f, 0f, 0f), new float3(1f, 0f, 0f), new float3(0f, 0f, 1f),
                new float3(1f, 0f, 1f) },
                Triangles = new[] { 0, 1, 2, 1, 3, 2 }
            };
            float[] values = new StretchField(wing)
                .Of(new[] { new float3(0f, 0f, 0f), new float3(1.1f, 0f, 0f), new float3(0f, 0f, 1f), new float3(1f, 0f, 1f) });

            Assert.That(values[0], Is.EqualTo(0.1f).Within(1e-6f));
            Assert.That(values[1], Is.EqualTo(0.1f).Within(1e-6f));
            Assert.That(values[2], Is.EqualTo(math.sqrt(1.1f * 1.1f + 1f) / math.sqrt(2f) - 1f).Within(1e-6f), "the diagonal");
        }
    }
}
