using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Authoring
{
    /// <summary>The skeleton of a traced wing in the plane of its picture: pixels, x to the right and z up.</summary>
    internal sealed class TracedSkeleton
    {
        /// <summary>Largest distance of a chain on a vein outside the wing, as a share of the wing's length.</summary>
        private const double k_Outside = 0.01;

        /// <summary>Share of a chain that must lie on its vein.</summary>
        private const double k_LeastShare = 0.4;

        private readonly PlanPoint[] m_Outline;
        private readonly PlanPoint[][] m_Fitted;
        private PlanPoint[][] m_Chains;
        private RadialVein[] m_Followed;

        /// <param name="fit">To the outline.</param>
        /// <param name="outline">Counterclockwise.</param>
        public TracedSkeleton(TracedFit fit, PlanPoint[] outline)
        {
            m_Outline = outline;
            m_Fitted = fit.Chains;
            m_Chains = m_Fitted;
            m_Followed = new RadialVein[m_Fitted.Length];
            Hinge = fit.Hinge;
            Span = fit.Span;
            foreach (PlanPoint point in outline)
                Length = Math.Max(Length, PlanPoint.Dot(point - Hinge, Span));
        }

        public PlanPoint Hinge { get; }

        /// <summary>Unit vector from the hinge to the tip.</summary>
        public PlanPoint Span { get; }

        /// <summary>Length of the wing along the span, pixels.</summary>
        public double Length { get; }

        /// <summary>[chain] True where the chain follows a vein.</summary>
        public bool[] FollowsVein => Array.ConvertAll(m_Followed, vein => vein != null);

        /// <summary>Lays chains along veins, as many as the skeleton stays valid with.</summary>
        public void Follow(List<RadialVein> veins)
        {
            var rim = new Polyline(m_Outline, true);
            var order = new RimOrder(rim, m_Fitted);
            var left = new List<RadialVein>(veins);
            while (true)
            {
                RadialVein[] followed = VeinChoice.Choose(m_Fitted, left, order, Length);
                if (Array.TrueForAll(followed, vein => vein == null))
                    return;
                var laid = VeinChains.Lay(m_Fitted, followed, rim, Length, true);
                int poor = Least(followed, chain => laid.Shares[chain]);
                bool isPoor = laid.Shares[poor] < k_LeastShare;
                if (!isPoor && (TryTake(laid) || TryTake(VeinChains.Lay(m_Fitted, followed, rim, Length, false))))
                {
                    m_Followed = followed;
                    return;
                }

                left.Remove(followed[isPoor ? poor : Least(followed, chain => followed[chain].Coverage)]);
            }
        }

        /// <summary>
        /// Placement in the picture of a mesh of a length: leading edge towards +Z, right wings along +X and left ones along −X.
        /// </summary>
        public WingPlacement Place(WingPicture picture, float length)
        {
            int last = m_Chains.Length - 1;
            PlanPoint forward = m_Chains[0][m_Chains[0].Length - 1] - m_Chains[last][m_Chains[last].Length - 1];
            bool isRight = PlanPoint.Cross(Span, forward) > 0.0;
            return new WingPlacement(picture, Hinge, isRight ? Span : Span * -1.0, length / Length);
        }

        /// <summary>The skeleton in the space of a mesh.</summary>
        /// <param name="placement">Of the mesh.</param>
        /// <param name="widths">Measures the veins that chains follow; null to leave their widths unknown.</param>
        public WingSkeleton ToWingSkeleton(WingPlacement placement, VeinWidths widths)
        {
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = Array.ConvertAll(m_Chains, chain => new JointChain(Array.ConvertAll(chain, placement.ToMesh)));
            float[][] measured = widths?.Measure(m_Chains, m_Followed);
            for (int i = 0; measured != null && i < measured.Length; i++)
                skeleton.Chains[i].veinWidths = measured[i];
            skeleton.Hinge = placement.ToMesh(Hinge);
            skeleton.SpanAxis = placement.ToMesh(Hinge + Span).normalized;
            skeleton.UpAxis = Vector3.up;
            return skeleton;
        }

        private bool TryTake(VeinChains laid)
        {
            if (!IsValid(laid.Chains))
                return false;
            m_Chains = laid.Chains;
            return true;
        }

        private bool IsValid(PlanPoint[][] chains)
        {
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = Array.ConvertAll(chains, chain => new JointChain(Array.ConvertAll(chain, ToVector)));
            skeleton.Hinge = ToVector(Hinge);
            skeleton.SpanAxis = ToVector(Span);
            bool isValid = skeleton.IsValid && Array.TrueForAll(chains, chain => Array.IndexOf(m_Fitted, chain) >= 0 || StaysInside(chain));
            UnityEngine.Object.DestroyImmediate(skeleton);
            return isValid;
        }

        private bool StaysInside(PlanPoint[] chain)
        {
            for (int j = 0; j + 1 < chain.Length; j++)
            {
                if (!IsInside(chain[j + 1]) || !IsInside((chain[j] + chain[j + 1]) * 0.5))
                    return false;
            }

            return IsInside(chain[0]);
        }

        private bool IsInside(PlanPoint place) =>
            Polygon.Contains(m_Outline, place) || Polyline.Distance(m_Outline, place, true) < k_Outside * Length;

        // The chain on a vein of which something is least.
        private static int Least(RadialVein[] followed, Func<int, double> of)
        {
            int least = -1;
            for (int i = 0; i < followed.Length; i++)
            {
                if (followed[i] != null && (least < 0 || of(i) < of(least)))
                    least = i;
            }

            return least;
        }

        private static Vector3 ToVector(PlanPoint place) => new Vector3((float)place.x, 0f, (float)place.z);
    }
}
