namespace Alate.Authoring
{
    /// <summary>A step from one pixel of a vein to another.</summary>
    internal readonly struct VeinLink
    {
        public readonly int to;
        public readonly double length;

        /// <summary>Cost of the link's length over that of a step along a vein; above 1 for one that leads over a gap.</summary>
        public readonly double dearness;

        public VeinLink(int to, double length, double dearness)
        {
            this.to = to;
            this.length = length;
            this.dearness = dearness;
        }

        public bool IsBridge => dearness > 1.0;
    }
}
