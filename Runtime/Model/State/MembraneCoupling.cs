namespace Alate
{
    /// <summary>Whether the membrane between the chains resists what would tear it.</summary>
    public enum MembraneCoupling
    {
        /// <summary>
        /// Neighbouring chains bend together where bending apart would tear the strip between them, joints stiffen on the way to their limit, springs resist folding, and
        /// delays of the flap are as large as the strips can take, all chains sweep as the leading one, and the wind is bounded: edges hold in any wind. The default.
        /// </summary>
        TwoWay,

        /// <summary>As printed: chains bend each by itself, delayed by Eq. 2, and the springs mend the positions afterwards. Wings tear in wind, which is felt as it is.</summary>
        OneWay,
    }
}
