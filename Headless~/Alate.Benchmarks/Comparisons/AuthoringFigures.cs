using System;
using System.Diagnostics;
using Alate.Authoring;
using Alate.Catalogue;
using Alate.Fitting;
using UnityEngine;
using Object = UnityEngine.Object;
using Random = System.Random;

namespace Alate.Benchmarks;

/// <summary>
/// Measures the waiting time of an artist: for a skeleton of a mesh, for a wing traced from a picture, for its first texture. The best of
/// some rounds each.
/// </summary>
internal static class AuthoringFigures
{
    private const int k_Rounds = 5, k_Side = 2000, k_TextureSide = 512;

    public static void Run(Report report)
    {
        WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
        SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
        SkeletonFitSettings hints = SkeletonFitSettings.Default;
        WingPicture picture = Photo(wing.Contour);
        report.Figure("fit_ms", "skeleton of a monarch's mesh", "ms",
            Best(() => Object.DestroyImmediate(SkeletonFitter.Fit(surface, hints).Skeleton)));
        report.Bounded(Targets.Trace, Best(() => WingTracer.Trace(picture, WingTracingSettings.Default)));
        report.Figure("paint_512_ms", "painting a monarch's texture of 512", "ms",
            Best(() => wing.Pattern.Paint(wing.Contour, k_TextureSide, k_TextureSide)));
    }

    private static double Best(Action act)
    {
        double best = double.MaxValue;
        for (int round = 0; round < k_Rounds; round++)
        {
            var watch = Stopwatch.StartNew();
            act();
            best = Math.Min(best, watch.Elapsed.TotalMilliseconds);
        }

        return best;
    }

    // A brown wing on uneven, noisy ground.
    private static WingPicture Photo(WingOutline outline)
    {
        var random = new Random(1);
        var pixels = new Color32[k_Side * k_Side];
        for (int k = 0; k < pixels.Length; k++)
        {
            double x = (k % k_Side + 0.5) / k_Side, y = (k / k_Side + 0.5) / k_Side;
            double span = 1.2 * x - 0.1, forward = outline.Front - 1.2 * y + 0.2;
            bool isWing = span is > 0 and < 1 && forward < outline.LeadingAt(span) && forward > outline.TrailingAt(span);
            double shade = (isWing ? 90 : 205 + 25 * x * y) + random.Next(-6, 7);
            pixels[k] = new Color32((byte)shade, (byte)(0.9 * shade), (byte)(0.8 * shade), 255);
        }

        return new WingPicture(k_Side, k_Side, pixels);
    }
}
