using System;

namespace Alate.Catalogue
{
    /// <summary>
    /// Places of the stations of an even mesh and the number of pieces of each chord: pieces are as long as stations are apart, and the
    /// triangles between stations, c_k + c_(k+1) for each strip, come to an exact number.
    /// </summary>
    internal static class ChordSegments
    {
        private const double k_PointedChord = 1e-6;

        /// <summary>Width of the outermost strip of a rounded tip over that of the others: a wider one would cut the round off.</summary>
        private const double k_CapStrip = 0.35;

        public static int[] For(WingOutline outline, int triangleCount, out double[] spans)
        {
            spans = Stations(outline, triangleCount);
            var stations = spans.Length;
            var chords = Array.ConvertAll(spans, outline.ChordAt);
            var ideal = IdealSegments(chords, triangleCount);
            var segments = Array.ConvertAll(ideal, pieces => Math.Max(1, (int)Math.Round(pieces)));
            for (var k = 0; k < stations; k++)
                segments[k] = chords[k] < k_PointedChord ? 0 : segments[k];

            MakeExact(segments, ideal, triangleCount);
            return segments;
        }

        public static int CountTriangles(int[] segments)
        {
            var count = 0;
            for (var k = 0; k + 1 < segments.Length; k++)
                count += segments[k] + segments[k + 1];

            return count;
        }

        private static double[] Stations(WingOutline outline, int triangleCount)
        {
            var spacing = Math.Sqrt(2 * outline.Area / triangleCount);
            var strips = Math.Clamp((int)Math.Round(1 / spacing), 2, triangleCount / 2 - 1);
            var spans = new double[strips + 1];
            var evenWidth = 1 / (outline.HasRoundedTip ? strips - 1 + k_CapStrip : strips);
            for (var k = 0; k < strips; k++)
                spans[k] = k * evenWidth;

            spans[strips] = 1;
            return spans;
        }

        private static double[] IdealSegments(double[] chords, int triangleCount)
        {
            var weighted = 0.0;
            for (var k = 0; k < chords.Length; k++)
                weighted += IsEnd(k, chords.Length) ? chords[k] : 2 * chords[k];

            return Array.ConvertAll(chords, chord => chord * triangleCount / weighted);
        }

        private static void MakeExact(int[] segments, double[] ideal, int triangleCount)
        {
            var missing = triangleCount - CountTriangles(segments);
            if (missing % 2 != 0)
            {
                var end = segments[0] > 0 ? 0 : segments.Length - 1;
                var step = missing > 0 || segments[end] < 2 ? 1 : -1;
                segments[end] += step;
                missing -= step;
            }

            for (; missing != 0; missing -= 2 * Math.Sign(missing))
            {
                var station = StationFarthestFromIdeal(segments, ideal, Math.Sign(missing));
                segments[station] += Math.Sign(missing);
            }
        }

        private static int StationFarthestFromIdeal(int[] segments, double[] ideal, int sign)
        {
            var best = -1;
            for (var k = 1; k + 1 < segments.Length; k++)
            {
                var allowed = segments[k] + sign >= 1;
                if (allowed && (best < 0 || Shortfall(k) > Shortfall(best)))
                    best = k;
            }

            return best;

            double Shortfall(int k) => sign * (ideal[k] - segments[k]) / Math.Max(1, ideal[k]);
        }

        private static bool IsEnd(int station, int count) => station == 0 || station == count - 1;
    }
}
