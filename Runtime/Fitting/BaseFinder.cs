using System;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Fitting
{
    /// <summary>
    /// Finds the anchor on a wing's outline, a place on its base: from the hinge, the body's point or side, whichever is given first; else
    /// from the mesh's origin, where wings commonly turn or the body lies; else at the narrower end.
    /// </summary>
    internal sealed class BaseFinder
    {
        /// <summary>
        /// Largest distance of a hinge from the outline, and of the mesh's origin to be taken for a hinge; shares of the wing's extent.
        /// </summary>
        private const double k_NearHinge = 0.1;

        /// <summary>Largest distance of the mesh's origin to be taken for the body, in extents of the wing.</summary>
        private const double k_NearBody = 3.0;

        /// <summary>
        /// Tilt of the body's side towards forward, radians, where it meets a straight edge: the front of the edge is the base, the rest
        /// may be a free inner margin.
        /// </summary>
        private const double k_Tilt = 0.17;

        /// <summary>Share of a direction that must lie in the wing's plane.</summary>
        private const double k_InPlane = 0.2;

        /// <summary>Sharpness of the extreme place in a direction, per extent.</summary>
        private const double k_Sharpness = 400.0;

        private const string k_OriginDoesNotTell = "nobody said where the body is, and the mesh's origin does not tell";

        private readonly ClosedCurve m_Outline;
        private readonly WingSheet m_Sheet;
        private readonly UnitSurface m_Unit;
        private readonly FitNotes m_Notes;
        private readonly PlanPoint m_Centre;
        private readonly double m_Extent;

        public BaseFinder(ClosedCurve outline, WingSheet sheet, UnitSurface unit, FitNotes notes)
        {
            m_Outline = outline;
            m_Sheet = sheet;
            m_Unit = unit;
            m_Notes = notes;
            m_Centre = Polygon.Centroid(outline.Samples);
            m_Extent = 2.0 * Math.Sqrt((outline.Samples[Polygon.Farthest(outline.Samples, m_Centre)] - m_Centre).LengthSquared);
        }

        /// <summary>True where a hinge was given and lies at the wing.</summary>
        public bool UsesHinge { get; private set; }

        /// <summary>The anchor's arc length on the outline.</summary>
        public double Find(in SkeletonFitSettings settings)
        {
            if (settings.hinge is Vector3 hinge)
                return FromHinge(m_Unit.ToUnit(hinge));
            if (settings.bodyPoint is Vector3 body)
                return m_Outline.Nearest(Plan(body));
            if (settings.bodySide is Vector3 side)
            {
                float3 direction = Directions.Unit(side);
                PlanPoint inPlane = m_Sheet.plane.ToPlan(direction);
                if (inPlane.LengthSquared > k_InPlane * k_InPlane)
                    return FromSide(PlanPoint.Unit(inPlane), settings.forward);
                return FromShape("the given body side stands on the wing");
            }

            return settings.isOriginUnknown ? FromShape(k_OriginDoesNotTell) : Guess();
        }

        private PlanPoint Plan(Vector3 meshPoint) => m_Sheet.plane.ToPlan(m_Unit.ToUnit(meshPoint));

        private double FromHinge(float3 hinge)
        {
            double anchor = m_Outline.Nearest(m_Sheet.plane.ToPlan(hinge)), distance = Distance(hinge, anchor);
            UsesHinge = distance <= k_NearHinge;
            if (!UsesHinge)
            {
                m_Notes.Warn(
                    SkeletonFitWarningKind.HingeOffWing, 0.7,
                    $"The given hinge lies {FitNotes.Percent(distance)} of the wing's extent off its outline; the wing turns about the "
                    + "nearest base instead.");
            }

            return anchor;
        }

        // From a place of the outline, seen from above, and from the surface; in extents of the wing.
        private double Distance(float3 point, double place)
        {
            PlanPoint seen = m_Sheet.plane.ToPlan(point);
            double beside = Math.Sqrt((m_Outline.At(place) - seen).LengthSquared);
            return Math.Max(beside, math.distance(point, m_Sheet.Lift(seen))) / m_Extent;
        }

        private double FromSide(PlanPoint side, Vector3? forward)
        {
            if (forward is Vector3 given)
            {
                PlanPoint ahead = m_Sheet.plane.ToPlan(Directions.Unit(given));
                ahead -= side * PlanPoint.Dot(ahead, side);
                if (ahead.LengthSquared > k_InPlane * k_InPlane)
                    side = side * Elementary.Cos(k_Tilt) + PlanPoint.Unit(ahead) * Elementary.Sin(k_Tilt);
            }

            int first = 0;
            for (int k = 1; k < m_Outline.Samples.Count; k++)
            {
                if (PlanPoint.Dot(m_Outline.Samples[k] - m_Outline.Samples[first], side) > 0.0)
                    first = k;
            }

            double from = (first - m_Outline.Samples.Count / 4) * m_Outline.Step,
                to = (first + m_Outline.Samples.Count / 4) * m_Outline.Step;
            PlanPoint extreme = m_Outline.Samples[first];
            return SoftMaximum.Find(
                from, to, m_Outline.Samples.Count, k_Sharpness / m_Extent, s => PlanPoint.Dot(m_Outline.At(s) - extreme, side), out _);
        }

        private double Guess()
        {
            float3 origin = m_Unit.ToUnit(Vector3.zero);
            PlanPoint seen = m_Sheet.plane.ToPlan(origin);
            double nearest = m_Outline.Nearest(seen), distance = Distance(origin, nearest);
            if (distance <= k_NearHinge)
            {
                Warn(0.85, "it is taken where the mesh's origin is");
                return nearest;
            }

            if (!m_Outline.Contains(seen) && distance <= k_NearBody)
            {
                Warn(0.75, "the body is taken to be at the mesh's origin");
                return nearest;
            }

            return FromShape(k_OriginDoesNotTell);
        }

        private double FromShape(string why)
        {
            var ends = new NarrowEnd(m_Outline, m_Centre);
            Warn(ends.Confidence, $"{why}: it is taken at the narrower end");
            return ends.Place;
        }

        private void Warn(double confidence, string how) =>
            m_Notes.Warn(SkeletonFitWarningKind.HingeGuessed, confidence, $"The hinge is a guess: {how}.");
    }
}
