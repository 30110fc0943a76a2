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
    /// <param name="alike">Groups that differ by less from the largest, sRGB and opacity, join it: speckles that nobody sees.</param>
    /// <returns>The colour that most have.</returns>
    public static float4 Reduce(float4[] colours, int count, float alike)
    {
        float4[] places = Array.ConvertAll(colours, colour => new float4(Shading.ToEncoded(colour.xyz), colour.w));
        var groups = new int[colours.Length];
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

        float4 ground = means[groups.GroupBy(group => group).OrderByDescending(group => group.Count()).First().Key];
        for (int k = 0; k < colours.Length; k++)
            colours[k] = Linear(math.length(means[groups[k]] - ground) < alike ? ground : means[groups[k]]);
        return Linear(ground);
    }

    private static float4 Linear(float4 encoded) => new(Shading.ToLinear(encoded.xyz), encoded.w);

    private static void Means(float4[] places, int[] groups, float4[] means)
    {
        var counts = new int[means.Length];
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
