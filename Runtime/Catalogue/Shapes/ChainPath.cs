using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// Path of one chain of a skeleton: from the base to its tip on the margin, straight or by way of a place inside the wing.
    /// </summary>
    internal readonly struct ChainPath
    {
        /// <param name="tip">The tip on the margin: share of its length from the leading corner of the base, 0 to 1.</param>
        /// <param name="via">A place on the way, wing lengths; null for a straight chain.</param>
        public ChainPath(double tip, PlanPoint? via = null)
        {
            Tip = tip;
            Via = via;
        }

        public double Tip { get; }

        public PlanPoint? Via { get; }

        /// <summary>Straight chains to the given tips.</summary>
        public static ChainPath[] Straight(params double[] tips) => System.Array.ConvertAll(tips, tip => new ChainPath(tip));

        /// <summary>The way from a root.</summary>
        public Polyline From(PlanPoint root, PlanPoint tip) =>
            new Polyline(Via is PlanPoint via ? new[] { root, via, tip } : new[] { root, tip });
    }
}
