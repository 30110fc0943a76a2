using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Deformation of a wing over one beat: the numbers by which wings are compared, in radians and ratios.</summary>
    [MovedFrom(true, null, "Alate")]
    public readonly struct WingDeformation
    {
        /// <summary>The numbers in the order of the properties.</summary>
        public WingDeformation(
            float twistRange,
            float camberMin,
            float camberMax,
            float tipBendRange,
            float tipBendMax,
            float lag,
            float tipLag,
            float stretchMax,
            float stretch99)
        {
            TwistRange = twistRange;
            CamberMin = camberMin;
            CamberMax = camberMax;
            TipBendRange = tipBendRange;
            TipBendMax = tipBendMax;
            Lag = lag;
            TipLag = tipLag;
            StretchMax = stretchMax;
            Stretch99 = stretch99;
        }

        /// <summary>
        /// Twist of the outer against the inner section, highest minus lowest of the beat, radians; see <see cref="SectionTwist"/>.
        /// </summary>
        public float TwistRange { get; }

        /// <summary>Lowest camber of the beat, share of the chord; negative is hollow above. See <see cref="SectionCamber"/>.</summary>
        public float CamberMin { get; }

        /// <summary>Highest camber of the beat, share of the chord.</summary>
        public float CamberMax { get; }

        /// <summary>Bend of the tip out of the plane, highest minus lowest of the beat, radians; see <see cref="TipBend"/>.</summary>
        public float TipBendRange { get; }

        /// <summary>Largest magnitude of that bend, radians.</summary>
        public float TipBendMax { get; }

        /// <summary>
        /// Phase by which the trailing edge follows the leading edge, beyond an undeformed wing's, radians; see <see cref="EdgeLag"/>.
        /// </summary>
        public float Lag { get; }

        /// <summary>Phase by which the tip follows the root that drives it, radians; see <see cref="Alate.TipLag"/>.</summary>
        public float TipLag { get; }

        /// <summary>Largest |l/l₀ − 1| of any edge at any time of the beat; see <see cref="EdgeStretch"/>.</summary>
        public float StretchMax { get; }

        /// <summary>The 99th percentile of |l/l₀ − 1| over all edges and times of the beat.</summary>
        public float Stretch99 { get; }
    }
}
