using System;
using System.Collections.Generic;
using System.Globalization;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Makes the radial skeleton of a wing (Sec. 4.1) from its mesh alone: finds the outline, the base, the tip and both edges, and lays
    /// chains that fan from the base, the first along the leading edge, all inside the wing and joints on its surface.
    /// </summary>
    public static class SkeletonFitter
    {
        /// <summary>Points of the resampled outline.</summary>
        private const int k_Samples = 1600;

        /// <summary>A skeleton for a mesh.</summary>
        /// <param name="mesh">A readable mesh of one wing; the triangles of all its submeshes count.</param>
        /// <param name="settings">What is known about it.</param>
        /// <exception cref="ArgumentNullException">There is no mesh.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A count of the settings is out of its range.</exception>
        /// <exception cref="ArgumentException">The mesh is not readable, broken, or no single wing, or a place or direction of the settings is
        /// not finite or zero. The message is one line.</exception>
        public static SkeletonFit Fit(Mesh mesh, in SkeletonFitSettings settings) => Fit(WingSurface.FromMesh(mesh), settings);

        /// <summary>A skeleton for a surface of plain arrays.</summary>
        /// <inheritdoc cref="Fit(Mesh, in SkeletonFitSettings)"/>
        public static SkeletonFit Fit(in WingSurface surface, in SkeletonFitSettings settings)
        {
            settings.Check();
            SurfaceCheck.Run(surface);
            string name = SurfaceCheck.Name(surface);
            var unit = new UnitSurface(surface);
            var notes = new FitNotes();
            WingSheet sheet = ReadSheet(name, unit, settings.up, notes);

            var outline = new ClosedCurve(sheet.outline, k_Samples);
            var finder = new BaseFinder(outline, sheet, unit, notes);
            double anchor = finder.Find(settings);
            WingView view = WingOrientation.Find(outline, anchor, sheet.plane, settings.forward, notes);
            ClosedCurve wing = view.Turn(outline, anchor);
            var marks = new WingLandmarks(wing);
            PlanPoint[][] chains = FanChains.Lay(wing, marks, settings.chains, settings.jointsPerChain);

            var lift = new SurfaceLift(sheet);
            var skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = Array.ConvertAll(
                chains, chain => new JointChain(Array.ConvertAll(chain, joint => unit.ToMesh(lift.Lift(view.FromWing(joint))))));
            skeleton.Hinge = finder.Hinge is float3 hinge ? unit.ToMesh(hinge) : skeleton.GetJoint(0, 0);
            skeleton.SpanAxis = sheet.plane.Direction(view.span);
            skeleton.UpAxis = sheet.plane.up;
            return new SkeletonFit(skeleton, (float)notes.Confidence, notes.Warnings, Places(sheet.rim), sheet.holes.ConvertAll(Places));

            Vector3[] Places(List<int> places) => places.ConvertAll(place => unit.ToMesh(sheet.points[place])).ToArray();
        }

        private static WingSheet ReadSheet(string name, UnitSurface unit, Vector3? up, FitNotes notes)
        {
            var upper = new UpperSide(up);
            var reader = new SheetReader(name, unit, upper);
            WingSheet sheet = reader.Read();
            if (upper.IsGuessed)
            {
                notes.Warn(
                    SkeletonFitWarningKind.UpperSideGuessed, upper.Confidence,
                    "The upper side is a guess, the front of the triangles: the up direction lies in the wing's plane.");
            }

            if (reader.IsShell)
                notes.Warn(SkeletonFitWarningKind.ClosedShell, 0.9, "The mesh is a shell; the joints lie on its upper side.");
            if (reader.PiecesIgnored > 0)
            {
                notes.Warn(
                    SkeletonFitWarningKind.PiecesIgnored, 0.95,
                    $"{reader.PiecesIgnored.ToString(CultureInfo.InvariantCulture)} smaller pieces on or under the wing had no say.");
            }

            return sheet;
        }
    }
}
