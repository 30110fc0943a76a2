using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Tests
{
    /// <summary>
    /// Small wings for tests: flat in the XZ plane, hinge at the origin, span along +X, leading edge along z = 0, up +Y. The trailing
    /// edge is straight (a rectangle) or a quarter of an ellipse.
    /// </summary>
    public static class TestWings
    {
        /// <summary>Default wing length, mesh units.</summary>
        public const float Length = 1f;

        /// <summary>Default chord at the base, mesh units.</summary>
        public const float Chord = 0.5f;

        /// <summary>A grid of columns × rows quads, two triangles each, normals up.</summary>
        public static SurfaceMesh Rectangle(int columns = 12, int rows = 6, float length = Length, float chord = Chord)
        {
            var positions = new Vector3[(columns + 1) * (rows + 1)];
            for (int c = 0; c <= columns; c++)
            {
                for (int r = 0; r <= rows; r++)
                    positions[c * (rows + 1) + r] = new Vector3(length * c / columns, 0f, -chord * r / rows);
            }

            return Surface("Rectangle", positions, columns, rows);
        }

        /// <summary>Grid under a quarter of an ellipse; tapers to a short edge at the tip.</summary>
        public static SurfaceMesh Ellipse(int columns = 12, int rows = 6, float length = Length, float chord = Chord)
        {
            SurfaceMesh surface = Rectangle(columns, rows, length, chord);
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].z *= Mathf.Sqrt(1f - 0.99f * Mathf.Pow(surface.positions[k].x / length, 2f));
            surface.name = "Ellipse";
            return surface;
        }

        /// <summary>
        /// Radial chains for either wing: roots over the forward part of the base, tips on the outline of the ellipse, which lies
        /// within the rectangle.
        /// </summary>
        public static WingSkeleton Fan(int chains = 5, int joints = 5, float length = Length, float chord = Chord)
        {
            const float k_RootShare = 0.4f, k_LastAngle = 1.25f;
            var made = new JointChain[chains];
            for (int i = 0; i < chains; i++)
            {
                float share = (float)i / (chains - 1), angle = k_LastAngle * share;
                var root = new Vector3(0f, 0f, -k_RootShare * chord * share);
                var tip = new Vector3(length * Mathf.Cos(angle), 0f, -chord * Mathf.Sin(angle));
                made[i] = Chain(root, tip, joints);
            }

            return Skeleton(made);
        }

        /// <summary>Parallel chains that cover the rectangle exactly.</summary>
        public static WingSkeleton Lattice(int chains = 5, int joints = 5, float length = Length, float chord = Chord)
        {
            var made = new JointChain[chains];
            for (int i = 0; i < chains; i++)
            {
                float z = -chord * i / (chains - 1);
                made[i] = Chain(new Vector3(0f, 0f, z), new Vector3(length, 0f, z), joints);
            }

            return Skeleton(made);
        }

        /// <summary>A skeleton of these chains with its hinge at their first root, span +X, up +Y.</summary>
        public static WingSkeleton Skeleton(params JointChain[] chains)
        {
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = chains;
            if (skeleton.JointsPerChain > 0)
                skeleton.Hinge = skeleton.GetJoint(0, 0);
            return skeleton;
        }

        /// <summary>A straight chain with evenly spaced joints.</summary>
        public static JointChain Chain(Vector3 root, Vector3 tip, int joints)
        {
            var made = new Vector3[joints];
            for (int j = 0; j < joints; j++)
                made[j] = root + (tip - root) * ((float)j / (joints - 1));
            return new JointChain(made);
        }

        /// <summary>The elliptical wing with its fan, baked; the caller releases it.</summary>
        /// <param name="patchCount">As in <see cref="WingRigSettings"/>; 0 for one patch per triangle.</param>
        public static WingRig Rig(int patchCount = 0) => Bake(Fan(), Ellipse(), patchCount);

        /// <summary>A rig that the caller releases.</summary>
        public static WingRig Bake(WingSkeleton skeleton, SurfaceMesh surface, int patchCount = 0) =>
            WingRig.Bake(skeleton, surface, new WingRigSettings { patchCount = patchCount });

        /// <summary>The surface as a mesh asset would hold it.</summary>
        public static Mesh ToMesh(SurfaceMesh surface)
        {
            var mesh = new Mesh { name = surface.name };
            if (surface.positions.Length > ushort.MaxValue)
                mesh.indexFormat = IndexFormat.UInt32;
            mesh.vertices = surface.positions;
            mesh.normals = surface.normals;
            mesh.tangents = surface.tangents;
            mesh.triangles = surface.triangles;
            return mesh;
        }

        private static SurfaceMesh Surface(string name, Vector3[] positions, int columns, int rows)
        {
            int[] triangles = new int[6 * columns * rows];
            int end = 0;
            for (int c = 0; c < columns; c++)
            {
                for (int r = 0; r < rows; r++)
                {
                    int a = c * (rows + 1) + r, b = a + rows + 1;
                    foreach (int index in new[] { a, b, a + 1, b, b + 1, a + 1 })
                        triangles[end++] = index;
                }
            }

            var normals = new Vector3[positions.Length];
            for (int k = 0; k < normals.Length; k++)
                normals[k] = Vector3.up;
            return new SurfaceMesh { name = name, positions = positions, normals = normals, triangles = triangles };
        }
    }
}
