namespace Alate
{
    /// <summary>
    /// Places of the masses of four wings about the centre of the body that they carry, and their momentum against it, at the end of a
    /// substep; in the wings' frames, lane = wing.
    /// </summary>
    /// <remarks>
    /// 60 bytes a wing: sums over the joints, so that a body reads no joints.
    /// </remarks>
    internal struct LaneMomentum
    {
        /// <summary>Σ m x over the joints, x from the body's centre, wing masses · L.</summary>
        public SoaFloat3 first;

        /// <summary>Σ m x² , y², z², wing masses · L².</summary>
        public SoaFloat3 squares;

        /// <summary>Σ m yz, zx, xy, wing masses · L².</summary>
        public SoaFloat3 products;

        /// <summary>Momentum Σ m v against the body, wing masses · L/s.</summary>
        public SoaFloat3 linear;

        /// <summary>Angular momentum Σ m x × v against the body, wing masses · L²/s.</summary>
        public SoaFloat3 angular;
    }
}
