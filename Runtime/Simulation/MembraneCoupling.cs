namespace Alate
{
    /// <summary>Whether the membrane between the chains resists what would tear it.</summary>
    public enum MembraneCoupling
    {
        /// <summary>
        /// Neighbouring chains bend together where bending apart would tear the strip between them, joints stiffen on the way to their limit, springs resist folding, and
        /// delays are as large as the strips can take: edges hold in any wind. The default.
        /// </summary>
        TwoWay,

        /// <summary>As printed: chains bend each by itself, and the springs mend the positions afterwards. Wings tear in wind.</summary>
        OneWay,
    }
}
