using System;
using Alate.Geometry;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Makes the radial skeleton of a right or left wing from its outline (Sec. 4.1): roots evenly on the base chord, tips evenly along the
    /// contour from the leading corner of the tip over the trailing edge, chain 0 along the leading edge, the others straight, joints
    /// evenly along each chain.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public static class SkeletonGenerator
    {
        /// <summary>Even steps of span in which an edge is walked to measure its arc length, here to 3·10⁻⁵ of it.</summary>
        private const int k_EdgeSteps = 400;

        /// <summary>Makes a skeleton.</summary>
        /// <param name="outline">The wing's contour.</param>
        /// <param name="chains">Radial chains, <see cref="WingSkeleton.MinChains"/> to <see cref="WingSkeleton.MaxChains"/>.</param>
        /// <param name="jointsPerChain">Joints of each chain, <see cref="WingSkeleton.MinJoints"/> to
        /// <see cref="WingSkeleton.MaxJoints"/>.</param>
        /// <param name="lastTipSpan">Span of the last chain's tip on the trailing edge, wing lengths, above 0 and below 1.</param>
        /// <param name="scale">Length of the wing in mesh units.</param>
        /// <param name="side">Left gives the mirror image.</param>
        /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
        public static WingSkeleton Generate(
            WingOutline outline, int chains, int jointsPerChain, double lastTipSpan, float scale = 1f, WingSide side = WingSide.Right)
        {
            Check(outline, chains, jointsPerChain, lastTipSpan, scale);
            Polyline rim = TipAndTrailingEdge(outline, lastTipSpan);
            var paths = new Polyline[chains];
            for (int i = 0; i < chains; i++)
            {
                paths[i] = i == 0
                    ? LeadingEdge(outline)
                    : new Polyline(new[] { Root(outline, i, chains), rim.At(rim.Length * i / (chains - 1)) });
            }

            return Make(paths, jointsPerChain, scale, side);
        }

        /// <summary>Makes a skeleton with chains along the given paths; the first one follows the leading edge to its tip.</summary>
        /// <param name="outline">The wing's contour.</param>
        /// <param name="chains">The chains from leading to trailing edge, their tips in order along the margin.</param>
        /// <param name="jointsPerChain">Joints of each chain.</param>
        /// <param name="scale">Length of the wing in mesh units.</param>
        /// <param name="side">Left gives the mirror image.</param>
        internal static WingSkeleton Generate(WingOutline outline, ChainPath[] chains, int jointsPerChain, float scale, WingSide side)
        {
            Polyline margin = WingRim.Margin(outline);
            var paths = new Polyline[chains.Length];
            for (int i = 0; i < chains.Length; i++)
            {
                double distance = margin.Length * chains[i].Tip;
                paths[i] = i == 0 ? margin.Until(distance) : chains[i].From(Root(outline, i, chains.Length), margin.At(distance));
            }

            return Make(paths, jointsPerChain, scale, side);
        }

        private static WingSkeleton Make(Polyline[] paths, int jointsPerChain, float scale, WingSide side)
        {
            float sign = side == WingSide.Right ? 1f : -1f;
            JointChain[] made = Array.ConvertAll(paths, path => new JointChain { joints = JointsAlong(path, jointsPerChain, scale, sign) });
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Hinge = made[0].joints[0];
            skeleton.SpanAxis = new Vector3(sign, 0f, 0f);
            skeleton.UpAxis = new Vector3(0f, 1f, 0f);
            skeleton.Chains = made;
            return skeleton;
        }

        private static Vector3[] JointsAlong(Polyline path, int count, float scale, float sign)
        {
            var joints = new Vector3[count];
            for (int j = 0; j < count; j++)
            {
                PlanPoint place = path.At(path.Length * j / (count - 1));
                joints[j] = new Vector3((float)(sign * scale * place.x), 0f, (float)(scale * place.z));
            }

            return joints;
        }

        private static PlanPoint Root(WingOutline outline, int chain, int chains) =>
            new PlanPoint(0.0, outline.LeadingAt(0) - outline.ChordAt(0) * chain / (chains - 1));

        private static Polyline LeadingEdge(WingOutline outline) =>
            Polyline.Trace(k_EdgeSteps, span => new PlanPoint(span, outline.LeadingAt(span)));

        private static Polyline TipAndTrailingEdge(WingOutline outline, double lastTipSpan)
        {
            var trailing = Polyline.Trace(k_EdgeSteps, share =>
            {
                double span = 1 + (lastTipSpan - 1) * share;
                return new PlanPoint(span, outline.TrailingAt(span));
            });
            return Polyline.Join(new Polyline(new[] { new PlanPoint(1.0, outline.LeadingAt(1)) }), trailing);
        }

        private static void Check(WingOutline outline, int chains, int jointsPerChain, double lastTipSpan, float scale)
        {
            if (outline == null)
                throw new ArgumentNullException(nameof(outline));

            if (chains < WingSkeleton.MinChains || chains > WingSkeleton.MaxChains)
            {
                throw new ArgumentOutOfRangeException(
                    nameof(chains), chains, $"A skeleton has {WingSkeleton.MinChains} to {WingSkeleton.MaxChains} chains.");
            }

            if (jointsPerChain < WingSkeleton.MinJoints || jointsPerChain > WingSkeleton.MaxJoints)
            {
                throw new ArgumentOutOfRangeException(
                    nameof(jointsPerChain), jointsPerChain, $"A chain has {WingSkeleton.MinJoints} to {WingSkeleton.MaxJoints} joints.");
            }

            if (!(lastTipSpan > 0 && lastTipSpan < 1))
            {
                throw new ArgumentOutOfRangeException(
                    nameof(lastTipSpan), lastTipSpan, "The last chain ends between the base and the tip.");
            }

            if (!(scale > 0 && scale <= float.MaxValue))
                throw new ArgumentOutOfRangeException(nameof(scale), scale, "The wing length is a positive number.");
        }
    }
}
