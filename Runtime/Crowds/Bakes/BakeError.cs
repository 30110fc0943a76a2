namespace Alate.Crowds
{
    /// <summary>Differences of a baked loop from the flown wings: distances over the wing length, angles in degrees.</summary>
    public struct BakeError
    {
        /// <summary>Largest distance halfway between two frames.</summary>
        public float between;

        /// <summary>Largest angle of a normal halfway between two frames, degrees.</summary>
        public float normalBetween;

        /// <summary>Largest distance between the ends of the flown loop, which the bake closes evenly over all frames.</summary>
        public float closure;

        /// <summary>Largest distance between the flown wings and skins that blend joints linearly with the same weights.</summary>
        public float linearSkin;
    }
}
