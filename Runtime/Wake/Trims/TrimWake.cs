using System;
using Alate.Flight;

namespace Alate.Wake
{
    /// <summary>
    /// Free wake by strips behind the beat of a trim, with the bob of the body in it: the air that <see cref="TrimBake"/> lets the wings
    /// meet.
    /// </summary>
    public sealed class TrimWake : ITrimWake
    {
        /// <summary>Beats until a wake has grown, and most beats until one of wide cores repeats.</summary>
        private const int k_GrownBeats = 2, k_MostBeats = 16;

        /// <summary>
        /// Change of the air from beat to beat below which a wake repeats, and difference of a beat from the mean of some from which that
        /// is no air of any beat, both over the size of the air.
        /// </summary>
        private const float k_Repeats = 0.03f, k_MostDifference = 0.25f;

        /// <summary>Factor on the substeps of flights with which forces of a wake and of its air replayed are compared.</summary>
        private const int k_Finer = 8;

        /// <summary>
        /// True where a wake that is another one in each beat has cores as wide as a chord. Where wings beat on and on in their own wake,
        /// rings of slender cores throw one another about; those of wide ones repeat, and their air is moved until, replayed, it gives
        /// their mean force. False, the default: the air is the mean of some beats, or none where they have nothing in common.
        /// </summary>
        public bool HasWideCores { get; set; }

        /// <inheritdoc/>
        /// <exception cref="ArgumentException">A wing has no surface, or one that sheds no wake.</exception>
        public bool Find(FlightModel model, TrimState trim, in FlightCondition condition, WingInflow[] pairs)
        {
            WingInflow[] air;
            var motion = new TrimMotion(model, trim, condition, pairs.Length);
            using (var wake = new TrimSheet(model, condition, motion, new WakeSettings()))
            {
                air = wake.Repeated(k_GrownBeats, k_GrownBeats, k_Repeats)
                    ?? (HasWideCores ? null : wake.Mean(k_MostDifference));
            }

            if (HasWideCores)
                air ??= Wide(model, trim, condition, pairs.Length);
            for (int pair = 0; pair < pairs.Length && air != null; pair++)
                pairs[pair] = pair < air.Length ? air[pair] : default;
            return air != null;
        }

        /// <summary>A wake of wide cores behind a trim.</summary>
        internal static TrimSheet WideBehind(FlightModel model, TrimState trim, in FlightCondition condition, int pairs)
        {
            var settings = new WakeSettings();
            settings.WidenCores();
            return new TrimSheet(model, condition, new TrimMotion(model, trim, condition, pairs, k_Finer), settings);
        }

        private static WingInflow[] Wide(FlightModel model, TrimState trim, in FlightCondition condition, int pairs)
        {
            using TrimSheet wake = WideBehind(model, trim, condition, pairs);
            WingInflow[] air = wake.Repeated(k_GrownBeats, k_MostBeats, k_Repeats);
            return air == null ? null : new FittedAir(model, trim, condition, air, k_Finer).Give(wake.Force);
        }
    }
}
