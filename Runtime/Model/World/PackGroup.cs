namespace Alate
{
    /// <summary>
    /// One index of the step job: packs and the bodies that their wings carry, closed under both. Packs whose wings carry no body are
    /// alone.
    /// </summary>
    internal struct PackGroup
    {
        /// <summary>First entry in the list of packs, and how many.</summary>
        public int firstPack, packCount;

        /// <summary>First entry in the list of bodies, and how many.</summary>
        public int firstBody, bodyCount;
    }
}
