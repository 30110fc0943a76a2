using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Catalogue
{
    /// <summary>
    /// Drawings and tuned numbers of the catalogue, which stay until somebody means to change them: a drawing has no law but itself. The
    /// measures of each part of each insect stand in Appearance.txt, to be read beside the pictures of the manual;
    /// ALATE_WRITE_APPEARANCE=1 writes them.
    /// </summary>
    public sealed class AppearanceTests
    {
        private const int k_Pixels = 96, k_Columns = 6, k_Rows = 4;

        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        [TestCaseSource(nameof(All))]
        public void AnInsect_IsAsItWasDrawn(InsectDefinition insect)
        {
            string file = FilePath();
            List<string> held = File.Exists(file) ? File.ReadAllLines(file).ToList() : [];
            List<string> now = [.. Lines(insect)];
            if (Environment.GetEnvironmentVariable("ALATE_WRITE_APPEARANCE") == "1")
            {
                held.RemoveAll(line => line.StartsWith(insect.Name + " ", StringComparison.Ordinal));
                File.WriteAllLines(file, held.Concat(now).OrderBy(line => line.Split(' ')[0], StringComparer.Ordinal));
                return;
            }

            string[] own = [.. held.Where(line => line.StartsWith(insect.Name + " ", StringComparison.Ordinal))];
            Assert.That(own, Has.Length.EqualTo(now.Count), "parts, wings and presets");
            for (int k = 0; k < own.Length; k++)
                Assert.That(IsSame(own[k], now[k]), $"Was drawn as\n{own[k]}\nand is now\n{now[k]}");
        }

        private static IEnumerable<string> Lines(InsectDefinition insect)
        {
            SurfaceMesh body = insect.Body.CreateSurface(1000f);
            foreach (List<List<int>> group in Groups(body))
                yield return $"{insect.Name} {Part(body, group)}";
            foreach (WingDefinition wing in insect.Wings)
            {
                string of = $"{insect.Name} {wing.Name}";
                yield return $"{of}: {Shape(wing)}";
                if (wing.Pattern != null)
                    yield return $"{of}, colours: {Colours(wing)}";
                foreach (InsectVariant variant in insect.Variants)
                    yield return $"{of}, {variant}: {Numbers(wing, variant)}";
            }
        }

        // The right half's pieces, and runs of hair or teeth together.
        private static IEnumerable<List<List<int>>> Groups(SurfaceMesh body)
        {
            List<List<int>> run = null;
            foreach (List<int> piece in BodyPieces.Of(body).OrderBy(piece => piece[0]))
            {
                if (BodyPieces.BoundsOf(body, piece).center.x < -1e-3f)
                    continue;
                if (piece.Count == 4 && run != null)
                {
                    run.Add(piece);
                    continue;
                }

                if (run != null)
                    yield return run;
                run = piece.Count == 4 ? [piece] : null;
                if (run == null)
                    yield return [piece];
            }

            if (run != null)
                yield return run;
        }

        private static string Part(SurfaceMesh body, List<List<int>> group)
        {
            var bounds = new Bounds(BodyPieces.BoundsOf(body, group[0]).center, Vector3.zero);
            double volume = 0.0, area = 0.0;
            double[] sums = new double[8];
            Vector3 middle = Vector3.zero;
            int corners = 0;
            foreach (List<int> piece in group)
            {
                bounds.Encapsulate(BodyPieces.BoundsOf(body, piece));
                volume += BodyPieces.Volume(body, piece);
                area += piece.Sum(corner => BodyPieces.AreaVector(body, corner).magnitude);
                foreach (int corner in piece.SelectMany(first => new[] { first, first + 1, first + 2 }))
                {
                    Color32 colour = body.colours[body.triangles[corner]];
                    double[] channels = [colour.r, colour.g, colour.b, colour.a];
                    for (int k = 0; k < 4; k++)
                    {
                        sums[k] += channels[k];
                        sums[4 + k] += channels[k] * channels[k];
                    }

                    middle += body.positions[body.triangles[corner]];
                    corners++;
                }
            }

            double[] means = [.. sums.Take(4).Select(sum => sum / corners)],
                spreads = [.. Enumerable.Range(0, 4).Select(k => Math.Sqrt(Math.Max(0, sums[4 + k] / corners - means[k] * means[k])))];
            return $"{group.Count} x {group.Sum(piece => piece.Count)} triangles from {Text(bounds.min)} to {Text(bounds.max)} mm "
                + $"about {Text(middle / corners)}, {Text(area)} mm2, {Text(volume)} mm3, colour {Text(means)} ±{Text(spreads)}";
        }

        private static string Shape(WingDefinition wing)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right, 1000f);
            double area = Enumerable.Range(0, surface.TriangleCount).Sum(k => BodyPieces.AreaVector(surface, 3 * k).magnitude);
            WingSkeleton skeleton = wing.CreateSkeleton(WingSide.Right, 1000f);
            string joints = string.Join(" ", skeleton.Chains.Select(chain => $"{Text(chain.joints[0])} {Text(chain.joints[^1])}"));
            double thick = skeleton.Chains.Sum(chain => (chain.veinWidths ?? []).Sum());
            string made = $"{surface.TriangleCount} triangles, {Text(area)} mm2, hinge {Text(1000f * wing.Hinge)} mm, "
                + $"{skeleton.ChainCount} x {skeleton.JointsPerChain} joints: {joints}, veins {Text(thick)}";
            UnityEngine.Object.DestroyImmediate(skeleton);
            return made;
        }

        // Mean colours of a few fields of the picture, from the rear up.
        private static string Colours(WingDefinition wing)
        {
            WingOutline outline = wing.Contour;
            int height = (int)Math.Round(k_Pixels * (outline.Front - outline.Rear));
            Color32[] picture = wing.Pattern.Paint(outline, k_Pixels, height);
            double[,] sums = new double[k_Columns * k_Rows, 5];
            for (int pixel = 0; pixel < picture.Length; pixel++)
            {
                int field = pixel / k_Pixels * k_Rows / height * k_Columns + pixel % k_Pixels * k_Columns / k_Pixels;
                Color32 colour = picture[pixel];
                sums[field, 0] += colour.r;
                sums[field, 1] += colour.g;
                sums[field, 2] += colour.b;
                sums[field, 3] += colour.a;
                sums[field, 4]++;
            }

            return string.Join(" ", Enumerable.Range(0, k_Columns * k_Rows)
                .Select(field => Text(Enumerable.Range(0, 4).Select(k => sums[field, k] / sums[field, 4]).ToArray())));
        }

        private static string Numbers(WingDefinition wing, InsectVariant variant)
        {
            WingPreset preset = wing.CreatePreset(ModelReading.Physical, variant);
            WingParameters made = preset.ToParameters();
            string text = string.Join(" ", WingParameterRange.All.Select(range => $"{range.Name} {Text(range.Of(ref made))}"));
            string more = $"length {Text(1000f * preset.Size.wingLength)} mass {Text(1e6f * preset.Size.wingMass)} "
                + $"insect {Text(1e6f * preset.Size.insectMass)} feet {Text(1000f * preset.Rest.feet)} rest {Text(preset.Rest.flap)} "
                + $"{Text(preset.Rest.sweep)} substeps {made.substepsPerBeat} coefficients {(int)made.options.coefficients}";
            UnityEngine.Object.DestroyImmediate(preset);
            return $"{text} {more}";
        }

        // Numbers may differ in their last digits, which libraries of mathematics round otherwise.
        private static bool IsSame(string one, string other)
        {
            const string number = @"-?\d+(\.\d+)?(E[-+]\d+)?";
            if (Regex.Replace(one, number, "#") != Regex.Replace(other, number, "#"))
                return false;
            return Regex.Matches(one, number).Zip(Regex.Matches(other, number)).All(pair =>
            {
                double a = double.Parse(pair.First.Value, CultureInfo.InvariantCulture),
                    b = double.Parse(pair.Second.Value, CultureInfo.InvariantCulture);
                return Math.Abs(a - b) <= Math.Max(2e-3, 2e-3 * Math.Abs(a));
            });
        }

        private static string Text(double value) => value.ToString("G5", CultureInfo.InvariantCulture);

        private static string Text(double[] values) => "(" + string.Join(" ", values.Select(Text)) + ")";

        private static string Text(Vector3 value) => Text([Rounded(value.x), Rounded(value.y), Rounded(value.z)]);

        private static double Rounded(float value) => Math.Round(value, 3) + 0.0;

        private static string FilePath([CallerFilePath] string here = null) =>
            Path.Combine(Path.GetDirectoryName(here), "Appearance.txt");
    }
}
