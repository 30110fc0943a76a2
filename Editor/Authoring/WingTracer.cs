using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Authoring
{
    /// <summary>
    /// Makes a mesh and a skeleton from a picture of one wing: its outline, triangles that fill it, and chains along its veins.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public static class WingTracer
    {
        /// <summary>Least share of the wing's rim that is clear; with less, the outline is in doubt.</summary>
        private const double k_ClearRim = 0.9;

        /// <summary>Share below which the outline is no wing's: most of it follows nothing in the picture.</summary>
        private const double k_LeastClearRim = 0.2;

        /// <summary>Traces a picture.</summary>
        /// <param name="picture">A silhouette, a line drawing or a photo of one wing on plain or transparent ground.</param>
        /// <param name="settings">What is known about the wing and wanted of the mesh.</param>
        /// <exception cref="ArgumentNullException">There is no picture.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A number of the settings is out of its range.</exception>
        /// <exception cref="ArgumentException">
        /// The hinge of the settings lies outside the picture, their direction is none, or so few triangles cannot fill the outline.
        /// </exception>
        /// <exception cref="FormatException">The picture shows no wing, more than one, or none that can be told from the ground; one
        /// line.</exception>
        public static WingTrace Trace(WingPicture picture, in WingTracingSettings settings)
        {
            if (picture == null)
                throw new ArgumentNullException(nameof(picture));
            settings.Check(picture);
            var working = new WorkingPicture(picture);
            var wing = WingSeparation.Of(working);
            double clear = wing.ClearRim;
            if (clear < k_LeastClearRim)
            {
                throw new FormatException(
                    $"No wing was found: what stands out has a faint edge on {Faint(clear)} % of its outline. A plain ground, or a "
                    + "transparent one, shows where the wing ends.");
            }

            PlanPoint[] outline = OutlineFinder.Find(wing, working.Factor);
            TriangleLinks mesh = OutlineMesher.Mesh(outline, settings.triangles, out _);
            var lines = new VeinLines(working, wing.Mask, outline);
            var fit = TracedFit.Make(mesh, settings, TracedHinge.Find(settings, lines, wing, working.Factor, outline));
            var skeleton = new TracedSkeleton(fit, outline);
            List<RadialVein> veins = lines.Radial(skeleton.Hinge, skeleton.Length);
            skeleton.Follow(veins);
            float confidence = clear < k_ClearRim ? (float)clear * fit.Confidence : fit.Confidence;
            VeinWidths widths = settings.veinWidths
                ? new VeinWidths(RidgeField.Shades(working, wing.Mask), working.Factor, skeleton.Length)
                : null;
            WingPlacement placement = skeleton.Place(picture, settings.length);
            return new WingTrace(
                placement, Array.ConvertAll(outline, ToPicture), Surface(mesh, placement), skeleton.ToWingSkeleton(placement, widths),
                skeleton.FollowsVein,
                veins.ConvertAll(vein => Array.ConvertAll(vein.Path, ToPicture)), confidence, Warnings(fit, wing, clear));
        }

        private static List<string> Warnings(TracedFit fit, WingSeparation wing, double clear)
        {
            var warnings = new List<string>(fit.Warnings);
            if (wing.MiddleOfCut != null)
                warnings.Add("The wing touches the picture's edge; what lies beyond it is missing.");
            if (clear < k_ClearRim)
                warnings.Add($"The wing's edge is faint on {Faint(clear)} % of the outline, which may be wrong there.");
            return warnings;
        }

        private static int Faint(double clear) => (int)Math.Ceiling(100.0 * (1.0 - clear));

        // In the plane y = 0, facing up, with the picture's texture coordinates.
        private static SurfaceMesh Surface(TriangleLinks mesh, WingPlacement placement)
        {
            var normals = new Vector3[mesh.points.Length];
            Array.Fill(normals, Vector3.up);
            return new SurfaceMesh
            {
                positions = Array.ConvertAll(mesh.points, placement.ToMesh),
                normals = normals,
                uvs = Array.ConvertAll(mesh.points, placement.ToTexture),
                triangles = mesh.Clockwise(),
            };
        }

        private static Vector2 ToPicture(PlanPoint place) => new Vector2((float)place.x, (float)-place.z);
    }
}
