using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Fitting
{
    /// <summary>Makes one clean sheet of the triangles of a surface, or throws with the reason.</summary>
    internal sealed class SheetReader
    {
        /// <summary>
        /// Distances within which vertices are welded, shares of the mesh's size; a wider one only where the mesh falls to pieces without.
        /// </summary>
        private static readonly float[] s_Tolerances = { 1e-6f, 1e-5f, 1e-4f, 1e-3f };

        /// <summary>Largest area of other pieces that are left out as debris, as a share of the wing's.</summary>
        private const double k_Debris = 0.02;

        /// <summary>Least share of the triangles' area that the outline of a single layer encloses.</summary>
        private const double k_OneLayer = 0.75;

        /// <summary>Least share of a shell's area, seen from above, of its area in space; a ball has ½.</summary>
        private const double k_ThinShell = 0.65;

        private readonly string m_Name;
        private readonly UnitSurface m_Surface;
        private readonly Vector3? m_Up;
        private readonly FitNotes m_Notes;
        private int m_PiecesIgnored;
        private bool m_IsShell;
        private float m_UpperConfidence;

        /// <param name="name">How messages call the surface, at the start of a sentence.</param>
        /// <param name="surface">A checked one.</param>
        /// <param name="up">The upper side as given.</param>
        /// <param name="notes">Takes the warnings.</param>
        public SheetReader(string name, UnitSurface surface, Vector3? up, FitNotes notes)
        {
            m_Name = name;
            m_Surface = surface;
            m_Up = up;
            m_Notes = notes;
        }

        /// <exception cref="ArgumentException">The surface is no single wing; the message is one line.</exception>
        public WingSheet Read()
        {
            string complaint = null;
            foreach (float tolerance in s_Tolerances)
            {
                WingSheet sheet = TryRead(tolerance, out string problem);
                if (problem == null)
                {
                    Warn(sheet);
                    return sheet;
                }

                complaint ??= problem;
            }

            throw new ArgumentException(complaint);
        }

        private WingSheet TryRead(float tolerance, out string problem)
        {
            List<int3> triangles = Distinct(VertexWeld.Places(m_Surface.points, tolerance));
            var boundary = new SheetBoundary(m_Surface.points, triangles, 2f * tolerance);
            List<List<int3>> pieces = SheetPieces.Of(m_Surface.points, triangles, boundary.junctions);
            WingSheet sheet = OneLayer(pieces[0], tolerance);
            problem = AreaBeside(sheet, pieces) > k_Debris * sheet.PlanArea ? Scattered(pieces) : null;
            m_PiecesIgnored = pieces.Count - 1;
            return sheet;
        }

        private List<int3> Distinct(int[] places)
        {
            var triangles = new List<int3>();
            var known = new HashSet<(int, int, int)>();
            int[] corners = m_Surface.triangles;
            for (int k = 0; k < corners.Length; k += 3)
            {
                var t = new int3(places[corners[k]], places[corners[k + 1]], places[corners[k + 2]]);
                float3[] p = m_Surface.points;
                bool hasArea = math.lengthsq(math.cross(p[t.y] - p[t.x], p[t.z] - p[t.x])) > 0f;
                int low = math.cmin(t), high = math.cmax(t);
                if (hasArea && known.Add((low, math.csum(t) - low - high, high)))
                    triangles.Add(t);
            }

            if (triangles.Count == 0)
                throw new ArgumentException($"{m_Name} has no triangle with an area.");
            if (triangles.Count == 1)
                throw new ArgumentException($"{m_Name} is a single triangle; a wing has at least two.");
            return triangles;
        }

        private WingSheet OneLayer(List<int3> triangles, float tolerance)
        {
            float3[] points = m_Surface.points;
            float3 normal = UpperSide.Choose(m_Up, PlaneFit.Normal(points, triangles), points, triangles, out m_UpperConfidence);
            var plane = WingPlane.Facing(normal);
            var sheet = new WingSheet(points, triangles, plane, 2f * tolerance);
            m_IsShell = sheet.OutlineShare < k_OneLayer;
            if (!m_IsShell)
                return sheet;

            double facing = sheet.PlanArea / sheet.Area;
            List<int3> upper = triangles.FindAll(t => Polygon.DoubledArea(sheet.plan[t.x], sheet.plan[t.y], sheet.plan[t.z]) < 0.0);
            if (upper.Count > 1 && facing > k_ThinShell)
            {
                var boundary = new SheetBoundary(points, upper, 2f * tolerance);
                sheet = new WingSheet(points, SheetPieces.Of(points, upper, boundary.junctions)[0], plane, 2f * tolerance);
                if (sheet.OutlineShare >= k_OneLayer)
                    return sheet;
            }

            throw new ArgumentException(
                $"{m_Name} has no outline: it is closed or folded, and {FitNotes.Percent(facing)} of its area faces up or down; "
                + "a wing is a sheet or a thin shell.");
        }

        private static double AreaBeside(WingSheet sheet, List<List<int3>> pieces)
        {
            double beside = 0.0;
            for (int piece = 1; piece < pieces.Count; piece++)
            {
                foreach (int3 t in pieces[piece])
                {
                    PlanPoint a = sheet.plane.ToPlan(sheet.points[t.x]), b = sheet.plane.ToPlan(sheet.points[t.y]);
                    PlanPoint c = sheet.plane.ToPlan(sheet.points[t.z]);
                    if (!Polygon.Contains(sheet.outline, (a + b + c) * (1.0 / 3.0)))
                        beside += 0.5 * Math.Abs(Polygon.DoubledArea(a, b, c));
                }
            }

            return beside;
        }

        private string Scattered(List<List<int3>> pieces)
        {
            double whole = 0.0, largest = SheetPieces.Area(m_Surface.points, pieces[0]);
            foreach (List<int3> piece in pieces)
                whole += SheetPieces.Area(m_Surface.points, piece);
            return $"{m_Name} is not one wing but {pieces.Count} pieces apart, the largest with "
                + $"{FitNotes.Percent(largest / whole)} of the area; "
                + "fit each wing by itself.";
        }

        private void Warn(WingSheet sheet)
        {
            if (m_UpperConfidence < 1f)
            {
                m_Notes.Warn(
                    SkeletonFitWarningKind.UpperSideGuessed, m_UpperConfidence,
                    "The upper side is a guess, the front of the triangles: the up direction lies in the wing's plane.");
            }

            if (m_IsShell)
                m_Notes.Warn(SkeletonFitWarningKind.ClosedShell, 0.9, "The mesh is a shell; the joints lie on its upper side.");
            if (m_PiecesIgnored > 0)
            {
                string pieces = m_PiecesIgnored == 1 ? "1 smaller piece" : $"{m_PiecesIgnored} smaller pieces";
                m_Notes.Warn(SkeletonFitWarningKind.PiecesIgnored, 0.95, $"{pieces} on, under or beside the wing had no say.");
            }

            SheetDoubts.Warn(sheet, m_Notes);
        }
    }
}
