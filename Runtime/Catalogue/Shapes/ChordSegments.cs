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
            int stations = spans.Length;
            double[] chords = Array.ConvertAll(spans, outline.ChordAt);
            double[] ideal = IdealSegments(chords, triangleCount);
            int[] segments = Array.ConvertAll(ideal, pieces => Math.Max(1, (int)Math.Round(pieces)));
            for (int k = 0; k < stations; k++)
                segments[k] = chords[k] < k_PointedChord ? 0 : segments[k];

            MakeExact(segments, ideal, triangleCount);
            return segments;
        }

        public static int CountTriangles(int[] segments)
        {
            int count = 0;
            for (int k = 0; k + 1 < segments.Length; k++)
                count += segments[k] + segments[k + 1];

            return count;
        }

        private static double[] Stations(WingOutline outline, int triangleCount)
        {
            double spacing = Math.Sqrt(2 * outline.Area / triangleCount);
            int strips = Math.Clamp((int)Math.Round(1 / spacing), 2, triangleCount / 2 - 1);
            double[] spans = new double[strips + 1];
            double evenWidth = 1 / (outline.HasRoundedTip ? strips - 1 + k_CapStrip : strips);
            for (int k = 0; k < strips; k++)
                spans[k] = k * evenWidth;

            spans[strips] = 1;
            return spans;
        }

        private static double[] IdealSegments(double[] chords, int triangleCount)
        {
            double weighted = 0.0;
            for (int k = 0; k < chords.Length; k++)
                weighted += IsEnd(k, chords.Length) ? chords[k] : 2 * chords[k];

            return Array.ConvertAll(chords, chord => chord * triangleCount / weighted);
        }

        private static void MakeExact(int[] segments, double[] ideal, int triangleCount)
        {
            int missing = triangleCount - CountTriangles(segments);
            if (missing % 2 != 0)
            {
                int end = segments[0] > 0 ? 0 : segments.Length - 1;
                int step = missing > 0 || segments[end] < 2 ? 1 : -1;
                segments[end] += step;
                missing -= step;
            }

            for (; missing != 0; missing -= 2 * Math.Sign(missing))
            {
                int station = StationFarthestFromIdeal(segments, ideal, Math.Sign(missing));
                segments[station] += Math.Sign(missing);
            }
        }

        private static int StationFarthestFromIdeal(int[] segments, double[] ideal, int sign)
        {
            int best = -1;
            for (int k = 1; k + 1 < segments.Length; k++)
            {
                bool allowed = segments[k] + sign >= 1;
                if (allowed && (best < 0 || Shortfall(k) > Shortfall(best)))
                    best = k;
            }

            return best;

            double Shortfall(int k) => sign * (ideal[k] - segments[k]) / Math.Max(1, ideal[k]);
        }

        private static bool IsEnd(int station, int count) => station == 0 || station == count - 1;
    }
}
