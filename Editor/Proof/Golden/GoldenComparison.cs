using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Alate.Proof
{
    /// <summary>Compares what a machine computes with golden tracks, thing by thing.</summary>
    internal static class GoldenComparison
    {
        private const float k_Percent = 100f;

        /// <summary>A line for each golden track, in its order.</summary>
        public static List<ProofLine> Lines(IReadOnlyList<GoldenTrack> golden, IReadOnlyList<GoldenTrack> computed) =>
            golden.Select(track => Line(track, computed.FirstOrDefault(other => other.Name == track.Name))).ToList();

        private static ProofLine Line(GoldenTrack golden, GoldenTrack computed)
        {
            string allowed = Text($"{golden.Allowed:0.######}");
            if (computed == null || computed.Values.Length != golden.Values.Length || computed.Things.Length != golden.Things.Length)
            {
                string found = computed == null ? "no such track" : Text($"{computed.Samples} samples of {computed.Things.Length} things");
                return ProofLine.Of(golden.Name, false, found, Text($"{golden.Samples} samples of {golden.Things.Length} things"));
            }

            (float most, int at) = Farthest(golden.Values, computed.Values);
            if (at < 0)
                return ProofLine.Of(golden.Name, true, "equal to the last bit", allowed);
            int sample = at / golden.Things.Length, thing = at % golden.Things.Length;
            int off = golden.Things.Where((_, k) => Reach(golden, computed, k) > golden.Allowed).Count();
            string note = Text($"worst: {golden.Things[thing]}, {k_Percent * (sample + 1) / golden.Samples:0} % of the time");
            if (off > 0)
                note += Text($"; {off} of {golden.Things.Length} beyond");
            return ProofLine.Of(golden.Name, most <= golden.Allowed, Text($"{most:0.000000}"), allowed, note);
        }

        // Index of the thing in all samples, -1 where all bits are equal. What is not a number is as far as can be.
        private static (float most, int at) Farthest(float[] golden, float[] computed)
        {
            float most = 0f;
            int at = -1;
            for (int k = 0; k < golden.Length; k += 3)
            {
                float distance = Distance(golden, computed, k);
                if (distance > most || (at < 0 && Differ(golden, computed, k)))
                {
                    most = distance;
                    at = k / 3;
                }
            }

            return (most, at);
        }

        private static float Reach(GoldenTrack golden, GoldenTrack computed, int thing)
        {
            float most = 0f;
            for (int k = 3 * thing; k < golden.Values.Length; k += 3 * golden.Things.Length)
                most = Math.Max(most, Distance(golden.Values, computed.Values, k));
            return most;
        }

        private static float Distance(float[] golden, float[] computed, int k)
        {
            double x = golden[k] - computed[k], y = golden[k + 1] - computed[k + 1], z = golden[k + 2] - computed[k + 2];
            double distance = Math.Sqrt(x * x + y * y + z * z);
            return double.IsNaN(distance) ? float.PositiveInfinity : (float)distance;
        }

        private static bool Differ(float[] golden, float[] computed, int k) =>
            BitConverter.SingleToInt32Bits(golden[k]) != BitConverter.SingleToInt32Bits(computed[k])
            || BitConverter.SingleToInt32Bits(golden[k + 1]) != BitConverter.SingleToInt32Bits(computed[k + 1])
            || BitConverter.SingleToInt32Bits(golden[k + 2]) != BitConverter.SingleToInt32Bits(computed[k + 2]);

        private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
