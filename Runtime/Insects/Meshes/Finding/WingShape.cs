using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Measures of a part that may be a wing, in the space of the insect: X right, Z ahead.</summary>
    internal readonly struct WingShape
    {
        // Area on one side of the middle plane from which a part belongs to that side.
        private const float k_OneSide = 0.8f;

        // Mean share of a triangle that faces across the sheet: 1 in a plane, 0.64 in a tube, 0.5 in a ball. Cambered wings have above 0.9.
        private const float k_Facing = 0.8f;

        // Smallest side over middle side of a box where only that is known.
        private const float k_BoxThickness = 0.2f;

        /// <summary>Area of all triangles, square units of the insect's space.</summary>
        public readonly float area;

        /// <summary>Middle of the area.</summary>
        public readonly Vector3 centroid;

        /// <summary>Bounds of the part.</summary>
        public readonly Bounds bounds;

        /// <summary>Share of the area that is right of the middle plane, 0 to 1.</summary>
        public readonly float rightShare;

        /// <summary>True where the mesh is thin and mostly even, as wings are and bodies and legs are not.</summary>
        public readonly bool isSheet;

        private WingShape(float area, Vector3 centroid, Bounds bounds, float rightShare, bool isSheet)
        {
            this.area = area;
            this.centroid = centroid;
            this.bounds = bounds;
            this.rightShare = rightShare;
            this.isSheet = isSheet;
        }

        /// <summary>Side of the body; none for a part that reaches over both.</summary>
        public WingSide? Side
        {
            get
            {
                if (rightShare >= k_OneSide)
                    return WingSide.Right;
                return rightShare <= 1f - k_OneSide ? WingSide.Left : (WingSide?)null;
            }
        }

        /// <summary>Measures triangles.</summary>
        /// <param name="positions">All vertices of the mesh.</param>
        /// <param name="part">The triangles.</param>
        /// <param name="toInsect">From mesh space to the insect's.</param>
        public static WingShape Of(Vector3[] positions, MeshSelection part, Matrix4x4 toInsect)
        {
            Vector3[] points = System.Array.ConvertAll(part.vertices, vertex => toInsect.MultiplyPoint3x4(positions[vertex]));
            var bounds = new Bounds(points[0], Vector3.zero);
            foreach (Vector3 point in points)
                bounds.Encapsulate(point);

            float area = 0f, right = 0f;
            Vector3 sum = Vector3.zero;
            var normals = new float3x3();
            for (int corner = 0; corner < part.triangles.Length; corner += 3)
            {
                Vector3 middle = Middle(points, part.triangles, corner);
                Vector3 normal = AreaNormal(points, part.triangles, corner);
                float size = normal.magnitude;
                area += size;
                right += middle.x > 0f ? size : 0f;
                sum += size * middle;
                if (size > 0f)
                    normals += Square(normal / size) * size;
            }

            Vector3 centroid = area > 0f ? sum / area : bounds.center;
            bool isSheet = area > 0f && IsSheet(points, part.triangles, area, MainAxis(normals));
            return new WingShape(area, centroid, bounds, area > 0f ? right / area : 0.5f, isSheet);
        }

        /// <summary>Estimates the shape from a box, for meshes that cannot be read.</summary>
        public static WingShape Of(Bounds box, Matrix4x4 toInsect)
        {
            var bounds = new Bounds(toInsect.MultiplyPoint3x4(box.center), Vector3.zero);
            for (int corner = 0; corner < 8; corner++)
            {
                var sign = new Vector3((corner & 1) * 2 - 1, (corner & 2) - 1, (corner & 4) / 2 - 1);
                bounds.Encapsulate(toInsect.MultiplyPoint3x4(box.center + Vector3.Scale(sign, box.extents)));
            }

            float[] sides = new[] { bounds.size.x, bounds.size.y, bounds.size.z };
            System.Array.Sort(sides);
            float right = bounds.size.x > 0f ? Mathf.Clamp01(bounds.max.x / bounds.size.x) : bounds.center.x > 0f ? 1f : 0f;
            return new WingShape(sides[1] * sides[2], bounds.center, bounds, right, sides[0] < k_BoxThickness * sides[1]);
        }

        private static bool IsSheet(Vector3[] points, int[] triangles, float area, Vector3 axis)
        {
            float facing = 0f;
            for (int corner = 0; corner < triangles.Length; corner += 3)
                facing += Mathf.Abs(Vector3.Dot(AreaNormal(points, triangles, corner), axis));
            return facing > k_Facing * area;
        }

        /// <summary>The direction that most of the area faces, by squaring the matrix until only its largest axis is left.</summary>
        private static Vector3 MainAxis(float3x3 normals)
        {
            for (int step = 0; step < 6; step++)
            {
                normals *= 1f / (normals.c0.x + normals.c1.y + normals.c2.z);
                normals = math.mul(normals, normals);
            }

            float3 axis = normals.c0;
            axis = math.lengthsq(normals.c1) > math.lengthsq(axis) ? normals.c1 : axis;
            axis = math.lengthsq(normals.c2) > math.lengthsq(axis) ? normals.c2 : axis;
            return math.normalize(axis);
        }

        private static float3x3 Square(float3 v) => new float3x3(v * v.x, v * v.y, v * v.z);

        private static Vector3 Middle(Vector3[] points, int[] triangles, int corner) =>
            (points[triangles[corner]] + points[triangles[corner + 1]] + points[triangles[corner + 2]]) / 3f;

        private static Vector3 AreaNormal(Vector3[] points, int[] triangles, int corner)
        {
            Vector3 origin = points[triangles[corner]];
            return 0.5f * Vector3.Cross(points[triangles[corner + 1]] - origin, points[triangles[corner + 2]] - origin);
        }
    }
}
