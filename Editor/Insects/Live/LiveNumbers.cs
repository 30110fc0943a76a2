using System;

namespace Alate.Editor
{
    /// <summary>Formats the numbers of a living insect for the inspector.</summary>
    internal static class LiveNumbers
    {
        /// <summary>Stretch between two joints above which a wing looks torn.</summary>
        private const float k_BearableStretch = 0.1f;

        private const string k_None = "—";

        /// <summary>Frequency as text: "8.8 Hz".</summary>
        public static string Frequency(InsectWings insect) => insect.Live == null ? k_None : Text($"{insect.Frequency:0.0#} Hz");

        /// <summary>Flap range as text: "96°".</summary>
        public static string FlapRange(InsectWings insect) => insect.Live == null ? k_None : Text($"{insect.FlapRange:0.#}°");

        /// <summary>Mean lift over the last beats as text: "0.67 of the weight".</summary>
        public static string Lift(ReadOnlySpan<BeatSample> folded) =>
            folded.Length == 0 ? k_None : Text($"{MeanLift(folded):0.00} of the weight");

        /// <summary>Level of detail as text: "Coarse Patches".</summary>
        public static string Detail(InsectWings insect)
        {
            switch (insect.Live == null ? default(WingDetail?) : insect.Detail)
            {
                case WingDetail.Full: return "Full";
                case WingDetail.FewerSubsteps: return "Fewer substeps";
                case WingDetail.CoarsePatches: return "Coarse patches";
                case WingDetail.WavesOnly: return "Waves only";
                case WingDetail.Frozen: return "Frozen";
                default: return k_None;
            }
        }

        /// <summary>Substeps of the last step of the first wing, as text.</summary>
        public static string Substeps(InsectWings insect) =>
            insect.Live == null ? k_None : Text($"{insect.Read(0).Substeps} in the last step");

        /// <summary>Stretch as text: "3 %".</summary>
        public static string Stretch(float stretch) => Text($"{100f * stretch:0} %");

        /// <summary>
        /// Warning line where a wing is driven outside its limits, with the largest stretch and the remedy; otherwise null.
        /// </summary>
        public static string Overstretched(float stretch)
        {
            return stretch > k_BearableStretch
                ? Text($"A wing stretches by {100f * stretch:0} %, more than it bears. Lower the wind, the speed or Strongest Wind, raise ")
                    + "Elasticity, or set Coupling to Two Way."
                : null;
        }

        /// <summary>Number of times any wing of the insect had to be put back into its driven pose.</summary>
        public static int Resets(InsectWings insect)
        {
            int resets = 0;
            for (int wing = 0; insect.Live != null && wing < insect.Live.wings.Length; wing++)
                resets += insect.Read(wing).Resets;
            return resets;
        }

        /// <summary>Mean of the lift over the whole beat; each sample weighs by the time for which it is the nearest.</summary>
        public static float MeanLift(ReadOnlySpan<BeatSample> folded)
        {
            if (folded.Length == 1)
                return folded[0].lift;
            double sum = 0.0;
            for (int k = 0; k < folded.Length; k++)
            {
                BeatSample next = folded[(k + 1) % folded.Length];
                double gap = next.Phase - folded[k].Phase + (k + 1 == folded.Length ? 1.0 : 0.0);
                sum += 0.5 * gap * (folded[k].lift + next.lift);
            }

            return (float)sum;
        }

        private static string Text(FormattableString text) => FormattableString.Invariant(text);
    }
}
