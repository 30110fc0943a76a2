namespace Alate
{
    /// <summary>Resistance of the membrane between the chains to being torn.</summary>
    public enum MembraneCoupling
    {
        /// <summary>
        /// Neighbouring chains bend together where bending apart would tear the strip between them, joints stiffen on the way to their
        /// limit, springs resist folding, and delays of the flap are as large as the strips can take, all chains sweep as the leading one,
        /// and the wind is bounded: edges hold in any wind. The default.
        /// </summary>
        TwoWay,

        /// <summary>
        /// Chains bend independently, delayed by Eq. 2, as printed, and the springs correct the positions afterwards. Wings tear in wind,
        /// which is not bounded.
        /// </summary>
        OneWay,
    }
}
