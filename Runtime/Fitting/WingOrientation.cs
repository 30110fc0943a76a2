using System;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Fitting
{
    /// <summary>
    /// Turns a wing's plan so that it is seen as a right wing's. With a forward direction the span runs at right angles to it, as an
    /// insect's flapping axis wants; without one, or with one along the wing, it runs through the wing's centre.
    /// </summary>
    internal static class WingOrientation
    {
        /// <summary>
        /// Share of the forward direction that must lie in the plane, and of that across the wing, to tell its edges apart: 30° from the
        /// direction to the wing's centre, which lies behind the span and would decide by itself which edge of a wing along the forward
        /// direction leads.
        /// </summary>
        private const double k_InPlane = 0.2;
        private const double k_Across = 0.5;

        /// <summary>
        /// Confidence in a guessed leading edge where both edges bulge alike, and where one is straight and the other is not.
        /// </summary>
        private const double k_EvenConfidence = 0.65;
        private const double k_StraightConfidence = 0.9;

        /// <summary>
        /// Difference of the areas on either side of the middle line, over the whole, at which an edge counts as the straight one.
        /// </summary>
        private const double k_ClearDifference = 0.3;

        /// <summary>Finds the view of the wing. Its span runs across a given forward direction, else through the wing's centre.</summary>
        /// <param name="outline">Its outline in plan.</param>
        /// <param name="anchor">Arc length of a place on its base.</param>
        /// <param name="plane">Of the plan.</param>
        /// <param name="forward">Given by the user, mesh space, or null.</param>
        /// <param name="notes">Takes the warnings.</param>
        /// <param name="isGuessed">Whether there was no forward direction of use.</param>
        public static WingView Find(
            ClosedCurve outline, double anchor, in WingPlane plane, Vector3? forward, FitNotes notes, out bool isGuessed)
        {
            PlanPoint from = outline.At(anchor);
            double reach = Math.Sqrt((outline.Samples[Polygon.Farthest(outline.Samples, from)] - from).LengthSquared);
            var centre = PlanPoint.Unit(Polygon.Centroid(outline.Samples) - from);

            string why = "nobody said which way is forward";
            if (forward is Vector3 given)
            {
                PlanPoint ahead = plane.ToPlan(Directions.Unit(given));
                double share = Math.Sqrt(ahead.LengthSquared), across = Math.Abs(PlanPoint.Cross(centre, ahead)) / Math.Max(share, 1e-9);
                isGuessed = share <= k_InPlane || across <= k_Across;
                if (!isGuessed)
                {
                    PlanPoint span = WingView.Across(PlanPoint.Unit(ahead), centre);
                    return new WingView(from, span, WingView.Across(span, ahead), reach);
                }

                why = share > k_InPlane ? "the forward direction runs along the wing" : "the forward direction stands on the wing";
            }

            isGuessed = true;
            PlanPoint leading = GuessForward(outline, from, centre, out double confidence);
            notes.Warn(
                SkeletonFitWarningKind.LeadingEdgeGuessed, confidence, $"The leading edge is a guess, the straighter edge: {why}.");
            return new WingView(from, centre, WingView.Across(centre, leading), reach);
        }

        // The wing bulges to the rear of the line from its base to its far end.
        private static PlanPoint GuessForward(ClosedCurve outline, PlanPoint from, PlanPoint centre, out double confidence)
        {
            int count = outline.Samples.Count;
            PlanPoint line = outline.Samples[Polygon.Farthest(outline.Samples, from)] - from;
            double left = 0.0, right = 0.0;
            for (int k = 0; k < count; k++)
            {
                PlanPoint a = outline.Samples[k] - from, b = outline.Samples[(k + 1) % count] - from;
                if (PlanPoint.Cross(line, a + b) > 0.0)
                    left += PlanPoint.Cross(a, b);
                else
                    right += PlanPoint.Cross(a, b);
            }

            double difference = (left - right) / (left + right);
            double clear = Math.Min(Math.Abs(difference) / k_ClearDifference, 1.0);
            confidence = k_EvenConfidence + (k_StraightConfidence - k_EvenConfidence) * clear;
            var toLeft = new PlanPoint(-centre.z, centre.x);
            return difference > 0.0 ? toLeft * -1.0 : toLeft;
        }
    }
}
