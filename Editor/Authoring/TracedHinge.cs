using Alate.Geometry;
using UnityEngine;

namespace Alate.Authoring
{
    /// <summary>Hinge of a traced wing, with its source.</summary>
    internal readonly struct TracedHinge
    {
        /// <summary>Confidence in a hinge: where the wing runs out of the picture, and where its veins come together.</summary>
        private const double k_EdgeConfidence = 0.7, k_FocusConfidence = 0.85;

        private TracedHinge(PlanPoint place, double confidence, string warning)
        {
            Place = place;
            Confidence = confidence;
            Warning = warning;
        }

        /// <summary>Place of the hinge, pixels, z up.</summary>
        public PlanPoint Place { get; }

        /// <summary>Confidence in the hinge, 0 to 1.</summary>
        public double Confidence { get; }

        /// <summary>Sentence for the user where the hinge is unsure; else null.</summary>
        public string Warning { get; }

        /// <summary>
        /// Finds the hinge: as the user said, else where the veins come together, where the wing was cut off, or at its more pointed end.
        /// </summary>
        public static TracedHinge Find(
            in WingTracingSettings settings, VeinLines lines, WingSeparation wing, int factor, PlanPoint[] outline)
        {
            if (settings.hinge is Vector2 given)
                return new TracedHinge(new PlanPoint(given.x, -given.y), 1.0, null);
            if (lines.Focus is PlanPoint focus)
                return new TracedHinge(focus, k_FocusConfidence, "The hinge is taken to be where the veins come together.");
            if (wing.MiddleOfCut is PlanPoint cut)
                return new TracedHinge(cut * factor, k_EdgeConfidence, "The hinge is taken to be where the wing runs out of the picture.");
            (PlanPoint end, double confidence) = PointedEnd.Of(outline);
            return new TracedHinge(
                end, confidence, "The hinge is a guess, the more pointed end of the wing or the one opposite its outer margin.");
        }
    }
}
