using System;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>A vein from near the hinge to the wing's margin.</summary>
    internal sealed class RadialVein
    {
        /// <param name="path">From the hinge to the margin.</param>
        /// <param name="rimDistance">Where along the outline it meets the margin.</param>
        /// <param name="coverage">Share of the way that was seen, not guessed.</param>
        public RadialVein(PlanPoint[] path, double rimDistance, double coverage)
        {
            Path = path;
            RimDistance = rimDistance;
            Coverage = coverage;
        }

        public PlanPoint[] Path { get; }

        public double RimDistance { get; }

        public double Coverage { get; }

        /// <summary>Vein in a picture that is larger by a factor.</summary>
        public RadialVein Scaled(double factor) =>
            new RadialVein(Array.ConvertAll(Path, point => point * factor), RimDistance * factor, Coverage);
    }
}
