using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Drawing;

/// <summary>Pictures in rows that fill a page.</summary>
public sealed class RowLaws
{
    private const float k_Width = 900f, k_Gap = 12f, k_Proportion = 0.72f;

    [Test]
    public void Rows_FillTheWidth_AtOneHeightEach_InOrder_WithTheGapBetween()
    {
        foreach (float[] aspects in Random(60))
        {
            var rows = new JustifiedRows(aspects, k_Width, k_Gap, k_Proportion);
            float top = k_Gap;
            foreach (IGrouping<float, int> row in Enumerable.Range(0, aspects.Length).GroupBy(k => rows[k].Corner.y))
            {
                Assert.That(row.Key, Is.EqualTo(top).Within(1e-3f));
                float left = k_Gap, height = rows[row.First()].Size.y;
                foreach (int k in row)
                {
                    Assert.That(rows[k].Corner.x, Is.EqualTo(left).Within(1e-2f));
                    Assert.That(rows[k].Size.y, Is.EqualTo(height));
                    Assert.That(rows[k].Size.x / rows[k].Size.y, Is.EqualTo(aspects[k]).Within(0.01).Percent);
                    left += rows[k].Size.x + k_Gap;
                }

                Assert.That(left, Is.EqualTo(k_Width).Within(0.05f));
                top += height + k_Gap;
            }

            Assert.That(rows.Height, Is.EqualTo(top).Within(1e-2f));
        }
    }

    // Beside every other way to cut the order into rows.
    [Test]
    public void NoOtherRows_AreNearerToEqualHeights()
    {
        foreach (float[] aspects in Random(40))
        {
            var rows = new JustifiedRows(aspects, k_Width, k_Gap, k_Proportion);
            double wanted = k_Width * Math.Sqrt(k_Proportion / aspects.Sum());
            double least = double.PositiveInfinity;
            for (int cuts = 0; cuts < 1 << (aspects.Length - 1); cuts++)
            {
                double off = 0.0;
                int first = 0;
                for (int end = 1; end <= aspects.Length; end++)
                {
                    if (end < aspects.Length && (cuts >> (end - 1) & 1) == 0)
                        continue;
                    double height = (k_Width - (end - first + 1) * k_Gap) / aspects[first..end].Sum();
                    off += Math.Pow(Math.Log(height / wanted), 2.0);
                    first = end;
                }

                least = Math.Min(least, off);
            }

            double made = Enumerable.Range(0, aspects.Length).Select(k => rows[k]).DistinctBy(place => place.Corner.y)
                .Sum(place => Math.Pow(Math.Log(place.Size.y / wanted), 2.0));
            Assert.That(made, Is.EqualTo(least).Within(1e-4));
        }
    }

    private static IEnumerable<float[]> Random(int count)
    {
        var random = new System.Random(11);
        for (int k = 0; k < count; k++)
            yield return [.. Enumerable.Range(0, 1 + random.Next(9)).Select(_ => math.exp(2f * random.NextSingle() - 0.7f))];
    }
}
