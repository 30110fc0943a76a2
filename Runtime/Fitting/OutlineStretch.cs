namespace Alate.Fitting
{
    /// <summary>A stretch of an outline between two arc lengths.</summary>
    internal readonly struct OutlineStretch
    {
        public readonly double from;
        public readonly double to;

        public OutlineStretch(double from, double to)
        {
            this.from = from;
            this.to = to;
        }

        public double Length => to - from;

        public bool Contains(double s) => s > from && s < to;

        public bool Overlaps(in OutlineStretch other) => from < other.to && to > other.from;
    }
}
