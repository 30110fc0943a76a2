using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Wings that are traced from painted pictures fly with the monarch's preset in still air and in wind: whatever their shape, they hold.</summary>
    public sealed class TracedWingWindTests
    {
        private const float k_Wind = 3f;
        private const int k_Side = 400;

        private static readonly string[] s_Names =
            ["monarch", "slender", "tailed", "scalloped", "fan", "stalked", "long stalk", "narrow", "butterfly", "hind wing", "oval"];

        private static readonly ConcurrentDictionary<string, WingTrace> s_Traces = new ConcurrentDictionary<string, WingTrace>();

        private static IEnumerable<TestCaseData> All =>
            from name in s_Names
            from variant in new[] { SpeciesVariant.Standard, SpeciesVariant.Expressive }
            select new TestCaseData(name, variant);

        [TestCaseSource(nameof(All))]
        public void ATracedWing_HoldsInStillAirAndInWind(string name, SpeciesVariant variant)
        {
            WingTrace trace = s_Traces.GetOrAdd(name, wing => Trace(Outline(wing)));
            WingSpecies species = Species.Find("monarch").Wings[0].CreateSpecies(ModelPreset.Physical, variant);
            using var flight = new SpeciesFlight(trace.Skeleton, trace.Surface.ToWingSurface(name), species);
            WindyFlight.Stretch still = WindyFlight.Steady(flight, 0f), windy = WindyFlight.Steady(flight, k_Wind, WindyFlight.SixDirections);
            TestContext.Progress.WriteLine($"{name} {variant}: still air {still}; 3 m/s {windy}");

            bool isExpressive = variant == SpeciesVariant.Expressive;
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
                // As a damselfly's: a fifth of the wing, nearly as narrow as a vein is thick.
                case "stalked": return Blade(x => 0.018 + (x < 0.18 ? 0.0 : 0.05 * Swell(x, 0.18)), x => 0.018 + (x < 0.18 ? 0.0 : 0.09 * Swell(x, 0.18)));
                case "long stalk": return Blade(x => 0.012 + (x < 0.35 ? 0.0 : 0.07 * Swell(x, 0.35)), x => 0.012 + (x < 0.35 ? 0.0 : 0.11 * Swell(x, 0.35)));
                case "narrow": return Blade(x => 0.012 + 0.018 * Swell(x, 0.0), x => 0.014 + 0.04 * Swell(x, 0.0));
                case "butterfly": return InsectOutlines.Make(OutlineKind.Butterfly, 3);
                case "hind wing": return InsectOutlines.Make(OutlineKind.HindWing, 5);
                case "oval": return InsectOutlines.Make(OutlineKind.Oval, 7);
                default: return DrawnWing.All.First(wing => wing.Name == name).Outline;
            }
        }

        private static double Swell(double x, double from) => Math.Sqrt(Math.Max(0.0, Math.Sin(Math.PI * Math.Min(1.0, (x - from) / (1.0 - from)))));

        // Counterclockwise, widths ahead of and behind the middle line, rounded off at the tip.
        private static Vector2[] Blade(Func<double, double> ahead, Func<double, double> behind)
        {
            const int steps = 300;
            double Taper(int k) => Math.Sqrt(Math.Max(0.0, 1.0 - Math.Pow((double)k / steps, 40.0)));
            var outline = new List<Vector2>();
            for (int k = 0; k <= steps; k++)
                outline.Add(new Vector2((float)k / steps, (float)(-behind((double)k / steps) * Taper(k))));
            for (int k = steps - 1; k >= 0; k--)
                outline.Add(new Vector2((float)k / steps, (float)(ahead((double)k / steps) * Taper(k))));
            return outline.ToArray();
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
