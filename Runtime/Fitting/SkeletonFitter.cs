using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Fitting
{
    /// <summary>
    /// Makes the radial skeleton of a wing (Sec. 4.1) from its mesh alone: finds the outline, the base, the tip and both edges, and lays
    /// chains that fan from the base, the first along the leading edge, all inside the wing and all joints on its surface.
    /// </summary>
    /// <remarks>
    /// The result does not depend on where the mesh has its vertices, nor on its position, size or side: it is computed on the outline
    /// resampled by arc length, in a view in which every wing is a right one of length 1.
    /// </remarks>
    [MovedFrom(true, "Alate", "Alate")]
    public static class SkeletonFitter
    {
        /// <summary>Points of the resampled outline.</summary>
        private const int k_Samples = 1600;

        /// <summary>Confidence in chains that are straight rays, because those that follow the wing do not fit.</summary>
        private const double k_RayConfidence = 0.5;

        /// <summary>A skeleton for a mesh.</summary>
        /// <param name="mesh">A readable mesh of one wing; the triangles of all its submeshes count.</param>
        /// <param name="settings">What is known about it.</param>
        /// <exception cref="ArgumentNullException">There is no mesh.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A count of the settings is out of its range.</exception>
        /// <exception cref="ArgumentException">The mesh is not readable, broken, or no single wing, or a place or direction of the settings
        /// is not finite or zero. The message is one line.</exception>
        public static SkeletonFit Fit(Mesh mesh, in SkeletonFitSettings settings) => Fit(SurfaceMesh.FromMesh(mesh), settings);

        /// <summary>A skeleton for a surface of plain arrays: a single sheet, a double-sided one or a thin closed shell.</summary>
        /// <inheritdoc cref="Fit(Mesh, in SkeletonFitSettings)"/>
        public static SkeletonFit Fit(SurfaceMesh surface, in SkeletonFitSettings settings)
        {
            settings.Check();
            SurfaceCheck.Run(surface);
            string name = SurfaceCheck.Name(surface);
            var notes = new FitNotes();
            var unit = new UnitSurface(surface);
            WingSheet sheet = new SheetReader(name, unit, settings.up, notes).Read();

            var outline = new ClosedCurve(sheet.outline, k_Samples);
            var finder = new BaseFinder(outline, sheet, unit, notes);
            double anchor = finder.Find(settings);
            WingView view = WingOrientation.Find(outline, anchor, sheet.plane, settings.forward, notes, out bool isGuessed);
            ClosedCurve wing = view.Turn(outline, anchor);
            var marks = new WingLandmarks(wing, notes);
            var fan = new FanChains(wing, marks, notes);
            PlanPoint[][] chains = null;

            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.UpAxis = sheet.plane.up;
            string problem = null;
            foreach (PlanPoint[][] layout in fan.Lay(settings.chains, settings.jointsPerChain))
            {
                chains = layout;
                Take(chains, settings, isGuessed ? view.FromWing(wing.At(marks.Tip)) - view.FromWing(chains[0][0]) : view.span);
                problem = Problem(skeleton);
                if (problem == null)
                    break;
            }

            // Rays in plan do not suit a surface that is not seen whole from above, such as a band with a twist.
            bool isHidden = notes.Warned(SkeletonFitWarningKind.FoldsOverItself) || notes.Warned(SkeletonFitWarningKind.StronglyCurved);
            int tries = isHidden ? 0 : RayChains.Tries;
            for (int attempt = 0; problem != null && attempt < tries; attempt++)
            {
                chains = RayChains.Lay(wing, marks, settings.chains, settings.jointsPerChain, attempt);
                Take(chains, settings, view.FromWing(RayChains.Middle(chains)) - view.FromWing(default));
                if (Problem(skeleton) != null)
                    continue;
                notes.Warn(
                    SkeletonFitWarningKind.ChainsLaidAsRays, k_RayConfidence,
                    $"The chains are straight rays from the base, as the usual ones do not fit: {problem}");
                problem = null;
            }

            Check(name, skeleton, problem);
            fan.Warn(chains);
            return new SkeletonFit(
                skeleton, (float)notes.Confidence, notes.Warnings, Places(sheet.rim), sheet.holes.ConvertAll(Places));

            void Take(PlanPoint[][] laid, in SkeletonFitSettings hints, PlanPoint span)
            {
                skeleton.Chains = Array.ConvertAll(
                    laid, chain => new JointChain(Array.ConvertAll(chain, joint => unit.ToMesh(sheet.Lift(view.FromWing(joint))))));
                skeleton.Hinge = finder.UsesHinge ? hints.hinge.Value : skeleton.GetJoint(0, 0);
                skeleton.SpanAxis = sheet.plane.Direction(span);
            }

            Vector3[] Places(List<int> places) => places.ConvertAll(place => unit.ToMesh(sheet.points[place])).ToArray();
        }

        private static string Problem(WingSkeleton skeleton)
        {
            List<SkeletonProblem> problems = skeleton.Validate();
            return problems.Count == 0 ? null : problems[0].Message;
        }

        private static void Check(string name, WingSkeleton skeleton, string problem)
        {
            if (problem == null)
                return;
            int chains = skeleton.ChainCount, joints = skeleton.JointsPerChain;
            Destroy(skeleton);
            throw new ArgumentException(
                $"{name} could not be given a skeleton of {chains} chains of {joints} joints: {problem} "
                + "Another hinge, other counts or the other side for the leading edge may help.");
        }

        private static void Destroy(WingSkeleton skeleton)
        {
            if (Application.isPlaying)
                UnityEngine.Object.Destroy(skeleton);
            else
                UnityEngine.Object.DestroyImmediate(skeleton);
        }
    }
}
