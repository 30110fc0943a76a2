using System;
using System.Linq;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>A few colours for many: each becomes the mean of its group, and groups are what lies nearest to its own mean (Lloyd 1982).</summary>
internal static class Palette
{
    private const int k_Rounds = 12;

    /// <summary>Replaces colours by so many; begins with the same count of each brightness, so that the result is always the same.</summary>
    /// <param name="colours">Linear light and opacity; changed.</param>
    /// <param name="count">Colours to keep.</param>
    /// <param name="alike">Groups that differ by less, sRGB and opacity, are one: speckles that nobody sees.</param>
    /// <returns>The colour that most have.</returns>
    public static float4 Reduce(float4[] colours, int count, float alike)
    {
        float4[] places = Array.ConvertAll(colours, colour => new float4(Shading.ToEncoded(colour.xyz), colour.w));
        int[] groups = new int[colours.Length];
        int[] byBrightness = Enumerable.Range(0, colours.Length).OrderBy(k => math.csum(places[k].xyz)).ToArray();
        for (int rank = 0; rank < byBrightness.Length; rank++)
            groups[byBrightness[rank]] = rank * count / byBrightness.Length;
        var means = new float4[count];
        for (int round = 0; round < k_Rounds; round++)
        {
            Means(places, groups, means);
            for (int k = 0; k < places.Length; k++)
                groups[k] = Nearest(places[k], means);
        }

        int[] joined = Join(means, groups, alike);
        for (int k = 0; k < colours.Length; k++)
            colours[k] = Linear(means[joined[groups[k]]]);
        return Linear(means[groups.GroupBy(group => joined[group]).OrderByDescending(group => group.Count()).First().Key]);
    }

    // [group] The largest group that it is like; itself where there is none.
    private static int[] Join(float4[] means, int[] groups, float alike)
    {
        int[] bySize = Enumerable.Range(0, means.Length).OrderByDescending(group => groups.Count(one => one == group)).ToArray();
        int[] joined = new int[means.Length];
        foreach (int group in bySize)
            joined[group] = bySize.First(larger => larger == group || (joined[larger] == larger && math.length(means[larger] - means[group]) < alike));
        return joined;
    }

    private static float4 Linear(float4 encoded) => new(Shading.ToLinear(encoded.xyz), encoded.w);

    private static void Means(float4[] places, int[] groups, float4[] means)
    {
        int[] counts = new int[means.Length];
        var sums = new float4[means.Length];
        for (int k = 0; k < places.Length; k++)
        {
            sums[groups[k]] += places[k];
            counts[groups[k]]++;
        }

        for (int group = 0; group < means.Length; group++)
        {
            if (counts[group] > 0)
                means[group] = sums[group] / counts[group];
        }
    }

    private static int Nearest(float4 place, float4[] means)
    {
        int nearest = 0;
        for (int group = 1; group < means.Length; group++)
        {
            if (math.lengthsq(means[group] - place) < math.lengthsq(means[nearest] - place))
                nearest = group;
        }

        return nearest;
    }
}
