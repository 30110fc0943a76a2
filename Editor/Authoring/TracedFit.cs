using System;
using System.Collections.Generic;
using Alate.Fitting;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Authoring
{
    /// <summary>Fits chains to the mesh of a traced wing in the plane of its picture: pixels, x to the right and z up.</summary>
    internal sealed class TracedFit
    {
        /// <summary>Sine between the span and the picture's up above which up does not tell the edges apart.</summary>
        private const double k_Upright = 0.87;

        /// <summary>Confidence in the upper edge of the picture being the leading one, and in the straighter one.</summary>
        private const float k_UpConfidence = 0.8f, k_ShapeConfidence = 0.6f;

        /// <summary>Power of the distance from the hinge by which parts of the wing weigh in the direction of its tip.</summary>
        private const double k_FarPower = 5.0;

        /// <summary>
        /// Distance, in extents of the wing, by which the picture's corner is moved away for the fitter, which assumes that a wing turns at
        /// its mesh's origin.
        /// </summary>
        private const float k_Away = 16f;

        private const string k_UpperEdge = "The leading edge is taken to be the upper one in the picture.";
        private const string k_PointsUp = "The leading edge is a guess, the straighter one: the wing points up or down in the picture.";
        private const string k_RunsAlong =
            "The leading edge is a guess, the straighter one: the direction that was given runs along the wing.";

        private readonly SurfaceMesh m_Surface;
        private readonly Vector3 m_Shift;
        private readonly List<string> m_Warnings = new List<string>();

        private TracedFit(TriangleLinks mesh)
        {
            m_Shift = k_Away * (float)new PlanBounds(mesh.points).Extent * new Vector3(1f, 0f, 1f);
            m_Surface = new SurfaceMesh
            {
                name = "the traced wing",
                positions = Array.ConvertAll(mesh.points, Shifted),
                triangles = mesh.Clockwise(),
            };
        }

        /// <summary>Chains, each from root to tip, from leading to trailing edge.</summary>
        public PlanPoint[][] Chains { get; private set; }

        public PlanPoint Hinge { get; private set; }

        /// <summary>Unit vector from the hinge towards the tip.</summary>
        public PlanPoint Span { get; private set; }

        /// <summary>Confidence in hinge, tip and edges, 0 to 1.</summary>
        public float Confidence { get; private set; } = 1f;

        /// <summary>A sentence for each guess.</summary>
        public IReadOnlyList<string> Warnings => m_Warnings;

        /// <summary>Fits chains.</summary>
        /// <param name="mesh">In pixels, counterclockwise.</param>
        /// <param name="settings">What the user said.</param>
        /// <param name="hinge">Where the wing turns.</param>
        public static TracedFit Make(TriangleLinks mesh, in WingTracingSettings settings, TracedHinge hinge)
        {
            var fit = new TracedFit(mesh);
            if (hinge.Warning != null)
                fit.Warn((float)hinge.Confidence, hinge.Warning);
            SkeletonFitSettings wanted = SkeletonFitSettings.Default;
            wanted.chains = settings.chains;
            wanted.jointsPerChain = settings.jointsPerChain;
            wanted.up = Vector3.up;
            wanted.forward = null;
            wanted.hinge = fit.Shifted(hinge.Place);
            fit.Apply(SkeletonFitter.Fit(fit.m_Surface, wanted));
            fit.Span = FarMiddle(mesh, fit.Hinge);
            // Now that the way to the tip is known, the leading edge lies at right angles to it.
            wanted.forward = fit.Forward(settings);
            SkeletonFit final = SkeletonFitter.Fit(fit.m_Surface, wanted);
            foreach (SkeletonFitWarning warning in final.Warnings)
                fit.m_Warnings.Add(warning.Message);
            fit.Confidence *= final.Confidence;
            fit.Apply(final);
            return fit;
        }

        private void Apply(SkeletonFit fit)
        {
            Chains = Array.ConvertAll(fit.Skeleton.Chains, chain => Array.ConvertAll(chain.joints, ToPlan));
            Hinge = ToPlan(fit.Skeleton.Hinge);
            UnityEngine.Object.DestroyImmediate(fit.Skeleton);
        }

        // Between the way to the farthest point and that to the middle of the wing: to the middle of what lies far out.
        private static PlanPoint FarMiddle(TriangleLinks mesh, PlanPoint hinge)
        {
            PlanPoint sum = default;
            for (int side = 0; side < mesh.SideCount; side += 3)
            {
                int a = mesh.corners[side], b = mesh.corners[side + 1], c = mesh.corners[side + 2];
                PlanPoint from = (mesh.points[a] + mesh.points[b] + mesh.points[c]) * (1.0 / 3.0) - hinge;
                sum += from * (Math.Pow(from.LengthSquared, 0.5 * (k_FarPower - 1.0)) * mesh.Area(a, b, c));
            }

            return PlanPoint.Unit(sum);
        }

        private Vector3 Forward(in WingTracingSettings settings)
        {
            PlanPoint side = settings.forward is Vector2 given ? new PlanPoint(given.x, -given.y) : new PlanPoint(0.0, 1.0);
            var left = new PlanPoint(-Span.z, Span.x);
            double across = PlanPoint.Dot(left, side) / Math.Sqrt(side.LengthSquared);
            bool isLeft = across > 0.0;
            if (across * across < 1.0 - k_Upright * k_Upright)
            {
                // The first fit took the straighter edge for the leading one; its last chain lies on the other side.
                isLeft = PlanPoint.Dot(left, Chains[Chains.Length - 1][Chains[0].Length - 1] - Hinge) < 0.0;
                Warn(k_ShapeConfidence, settings.forward == null ? k_PointsUp : k_RunsAlong);
            }
            else if (settings.forward == null)
            {
                Warn(k_UpConfidence, k_UpperEdge);
            }

            return (isLeft ? 1f : -1f) * new Vector3((float)left.x, 0f, (float)left.z);
        }

        private void Warn(float confidence, string warning)
        {
            Confidence *= confidence;
            m_Warnings.Add(warning);
        }

        private Vector3 Shifted(PlanPoint point) => new Vector3((float)point.x, 0f, (float)point.z) + m_Shift;

        private PlanPoint ToPlan(Vector3 place) => new PlanPoint(place.x - m_Shift.x, place.z - m_Shift.z);
    }
}
