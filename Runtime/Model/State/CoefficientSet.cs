using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>The lift and drag coefficients as functions of the angle of attack (Sec. 5.2, Fig. 6).</summary>
    [MovedFrom(true, null, "Alate")]
    public enum CoefficientSet
    {
        /// <summary>
        /// C_L = 0.225 + 1.58 sin(2.13α − 7.20°), C_D = 1.92 − 1.55 cos(2.04α − 9.82°): the fit Dickinson, Lehmann and Sane (1999) measured
        /// on a model fly wing, which the paper names as its source. The default, because its lift falls to zero again near 90°, as a
        /// plate's does.
        /// </summary>
        Dickinson1999,

        /// <summary>
        /// The polynomials of the paper's Fig. 6: l = −0.00095953α² + 0.090635α − 0.34182 and
        /// d = −0.0000079518α³ + 0.0011527α² + 0.0063148α + 0.51127, α in degrees. Lift is negative below 3.9°.
        /// </summary>
        Paper,

        /// <summary>
        /// C_L = 1.8 sin 2α, C_D = 0.05 + 1.9 sin²α: a thin flat plate after its stall; the one to take in water and for fins.
        /// </summary>
        FlatPlate,

        /// <summary>
        /// The lift of <see cref="Dickinson1999"/> and the drag that Azuma and Watanabe (1988) measured on a dragonfly's wing, mean of the
        /// stream from above and from below: C_D = 0.094 + 1.906 s + s (1 − s)(−0.388 + 0.168 s + 2.14 s²), s = sin²α, fitted within 0.014.
        /// A quarter of the drag of a fly's wing at small angles: for larger insects.
        /// </summary>
        Dragonfly,
    }
}
