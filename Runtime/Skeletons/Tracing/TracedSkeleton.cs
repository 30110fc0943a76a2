using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>The skeleton of a traced wing in the plane of its picture: pixels, x to the right and z up.</summary>
    internal sealed class TracedSkeleton
    {
        /// <summary>A chain on a vein stays in the wing but for this share of its length.</summary>
        private const double k_Outside = 0.01;

        private readonly PlanPoint[] m_Outline;
        private readonly PlanPoint[][] m_Fitted;
        private PlanPoint[][] m_Chains;

        /// <param name="fit">To the outline.</param>
        /// <param name="outline">Counterclockwise.</param>
        public TracedSkeleton(TracedFit fit, PlanPoint[] outline)
        {
            m_Outline = outline;
            m_Fitted = fit.Chains;
            m_Chains = m_Fitted;
            FollowsVein = new bool[m_Fitted.Length];
            Hinge = fit.Hinge;
            Span = fit.Span;
            foreach (PlanPoint point in outline)
                Length = Math.Max(Length, PlanPoint.Dot(point - Hinge, Span));
        }

        public PlanPoint Hinge { get; }

        /// <summary>Unit vector from the hinge to the tip.</summary>
        public PlanPoint Span { get; }

        /// <summary>Of the wing along the span, pixels.</summary>
        public double Length { get; }

        /// <summary>[chain]</summary>
        public bool[] FollowsVein { get; private set; }

        /// <summary>Lays chains along veins, as many as the skeleton stays valid with.</summary>
        public void Follow(List<RadialVein> veins)
        {
            var rim = new RimLine(m_Outline);
            var order = new RimOrder(rim, m_Fitted);
            RadialVein[] followed = VeinChoice.Choose(m_Fitted, veins, order, Length);
            for (; Array.Exists(followed, vein => vein != null); followed[WorstCovered(followed)] = null)
            {
                if (TryLay(followed, rim, true) || TryLay(followed, rim, false))
                {
                    FollowsVein = Array.ConvertAll(followed, vein => vein != null);
                    return;
                }
            }
        }

        /// <summary>How a mesh of a length lies in the picture: leading edge towards +Z, right wings along +X and left ones along −X.</summary>
        public WingPlacement Place(WingPicture picture, float length)
        {
            int last = m_Chains.Length - 1;
            PlanPoint forward = m_Chains[0][m_Chains[0].Length - 1] - m_Chains[last][m_Chains[last].Length - 1];
            bool isRight = PlanPoint.Cross(Span, forward) > 0.0;
            return new WingPlacement(picture, Hinge, isRight ? Span : Span * -1.0, length / Length);
        }

        /// <summary>The skeleton in the space of a mesh.</summary>
        public WingSkeleton ToWingSkeleton(WingPlacement placement)
        {
            var skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = Array.ConvertAll(m_Chains, chain => new JointChain(Array.ConvertAll(chain, placement.ToMesh)));
            skeleton.Hinge = placement.ToMesh(Hinge);
            skeleton.SpanAxis = placement.ToMesh(Hinge + Span).normalized;
            skeleton.UpAxis = Vector3.up;
            return skeleton;
        }

        private bool TryLay(RadialVein[] followed, RimLine rim, bool ownRoots)
        {
            PlanPoint[][] chains = VeinChains.Lay(m_Fitted, followed, rim, Length, ownRoots);
            if (!IsValid(chains))
                return false;
            m_Chains = chains;
            return true;
        }

        private bool IsValid(PlanPoint[][] chains)
        {
            var skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = Array.ConvertAll(chains, chain => new JointChain(Array.ConvertAll(chain, ToVector)));
            skeleton.Hinge = ToVector(Hinge);
            skeleton.SpanAxis = ToVector(Span);
            bool isValid = skeleton.IsValid && Array.TrueForAll(chains, chain => Array.TrueForAll(chain, IsInside));
            UnityEngine.Object.DestroyImmediate(skeleton);
            return isValid;
        }

        private bool IsInside(PlanPoint joint) =>
            ClosedPath.Holds(m_Outline, joint) || ClosedPath.Distance(m_Outline, joint) < k_Outside * Length;

        private static int WorstCovered(RadialVein[] followed)
        {
            int worst = -1;
            for (int i = 0; i < followed.Length; i++)
            {
                if (followed[i] != null && (worst < 0 || followed[i].Coverage < followed[worst].Coverage))
                    worst = i;
            }

            return worst;
        }

        private static Vector3 ToVector(PlanPoint place) => new Vector3((float)place.x, 0f, (float)place.z);
    }
}
