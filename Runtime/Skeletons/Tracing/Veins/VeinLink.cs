namespace Alate
{
    /// <summary>A step from one pixel of a vein to another.</summary>
    internal readonly struct VeinLink
    {
        public readonly int to;
        public readonly double length;

        /// <summary>Whether it leads over a gap.</summary>
        public readonly bool isBridge;

        public VeinLink(int to, double length, bool isBridge)
        {
            this.to = to;
            this.length = length;
            this.isBridge = isBridge;
        }
    }
}
