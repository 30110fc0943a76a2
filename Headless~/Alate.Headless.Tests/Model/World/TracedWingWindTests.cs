using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using Alate.Authoring;
using Alate.Catalogue;
using Alate.Editor.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>
    /// Wings that are traced from painted pictures fly with the monarch's preset in still air and in wind: whatever their shape, they hold.
    /// </summary>
    public sealed class TracedWingWindTests
    {
        private const float k_Wind = 3f;
        private const int k_Side = 400;

        private static readonly string[] s_Names =
            ["monarch", "slender", "tailed", "scalloped", "fan", "butterfly", "hind wing", "oval", "broad butterfly", "broad hind wing",
                "stalked", "narrow"];

        private static readonly ConcurrentDictionary<string, WingTrace> s_Traces = new ConcurrentDictionary<string, WingTrace>();

        private static IEnumerable<TestCaseData> Some => Cases(IsQuick);

        private static IEnumerable<TestCaseData> Others => Cases((shape, variant) => !IsQuick(shape, variant));

        private static IEnumerable<TestCaseData> Cases(Func<int, InsectVariant, bool> wanted) =>
            from shape in Enumerable.Range(0, s_Names.Length)
            from variant in new[] { InsectVariant.Standard, InsectVariant.Expressive }
            where wanted(shape, variant)
            select new TestCaseData(s_Names[shape], variant);

        private static bool IsQuick(int shape, InsectVariant variant) =>
            s_Names[shape] == "butterfly" && variant == InsectVariant.Expressive;

        [TestCaseSource(nameof(Some))]
        public void ATracedWing_HoldsInStillAirAndInWind(string name, InsectVariant variant) => AssertHolds(name, variant);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void AnyOtherTracedWing_HoldsInStillAirAndInWind(string name, InsectVariant variant) => AssertHolds(name, variant);

        private static void AssertHolds(string name, InsectVariant variant)
        {
            WingTrace trace = s_Traces.GetOrAdd(name, wing => Trace(Outline(wing)));
            WingPreset preset = InsectCatalogue.Find("monarch").Wings[0].CreatePreset(ModelReading.Physical, variant);
            using var flight = new SpeciesFlight(trace.Skeleton, trace.Surface, preset);
            WindyFlight.Stretch still = WindyFlight.Steady(flight, 0f),
                windy = WindyFlight.Steady(flight, k_Wind, WindyFlight.SixDirections);
            TestContext.Progress.WriteLine($"{name} {variant}: still air {still}; 3 m/s {windy}");

            bool isExpressive = variant == InsectVariant.Expressive;
            foreach (WindyFlight.Stretch stretch in new[] { still, windy })
            {
                Assert.That(stretch.Largest, Is.LessThanOrEqualTo(isExpressive ? 0.15 : 0.10), $"largest: {stretch}");
                Assert.That(stretch.Share99, Is.LessThanOrEqualTo(isExpressive ? 0.06 : 0.04), $"99 of 100 edges: {stretch}");
                Assert.That(stretch.Resets, Is.Zero);
            }
        }

        private static Vector2[] Outline(string name)
        {
            switch (name)
            {
                case "stalked": return BladeOutline.Stalked;
                case "narrow": return BladeOutline.Narrow;
                case "butterfly": return InsectOutlines.Make(OutlineKind.Butterfly, 3);
                case "hind wing": return InsectOutlines.Make(OutlineKind.HindWing, 5);
                case "broad butterfly": return InsectOutlines.Make(OutlineKind.Butterfly, 8);
                case "broad hind wing": return InsectOutlines.Make(OutlineKind.HindWing, 9);
                case "oval": return InsectOutlines.Make(OutlineKind.Oval, 7);
                default: return DrawnWing.All.First(wing => wing.Name == name).Outline;
            }
        }

        private static WingTrace Trace(Vector2[] outline)
        {
            var place = new WingPlace(outline, k_Side, 0f, false, 0.86f);
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.hinge = place.At(Vector2.zero);
            return WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), settings);
        }
    }
}
