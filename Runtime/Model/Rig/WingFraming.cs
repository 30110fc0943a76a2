using System;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Lays the wing frame over a skeleton and its mesh.</summary>
    internal static class WingFraming
    {
        /// <exception cref="ArgumentException">No vertex of a triangle lies beyond the hinge along the span, or all too far.</exception>
        public static WingFrame Frame(WingSkeleton skeleton, SurfaceMesh surface)
        {
            WingAxes.TryMake(skeleton.SpanAxis, skeleton.UpAxis, out float3x3 axes);
            bool mirrored = new SkeletonPlan(skeleton, axes).SignedArea() > 0.0;
            if (mirrored)
                axes.c2 = -axes.c2;

            float3 hinge = skeleton.Hinge;
            float length = 0f;
            foreach (int index in surface.triangles)
                length = math.max(length, math.dot((float3)surface.positions[index] - hinge, axes.c0));
            if (length <= 0f)
                throw new ArgumentException($"{SurfaceCheck.Name(surface)} lies behind the hinge of its skeleton.");
            return new WingFrame(hinge, axes, length, mirrored);
        }

        /// <summary>Converts vertex positions to the wing frame.</summary>
        /// <exception cref="ArgumentException">The mesh is too large for its positions to be told apart.</exception>
        public static float3[] ToWing(in WingFrame frame, SurfaceMesh surface)
        {
            var points = new float3[surface.positions.Length];
            for (int k = 0; k < points.Length; k++)
            {
                points[k] = frame.ToWing(surface.positions[k]);
                if (!math.all(math.isfinite(points[k])))
                    throw new ArgumentException($"{SurfaceCheck.Name(surface)}: vertex {k} lies too far away.");
            }

            return points;
        }
    }
}
