using System.Globalization;
using System.Text;
using Alate.Authoring;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>A wing of the user's own as text, from <see cref="TestWings"/>.</summary>
    internal static class OwnWing
    {
        /// <summary>The elliptical wing as an OBJ file.</summary>
        /// <param name="offset">Moves the mesh away from its skeleton.</param>
        /// <param name="side">Left mirrors x; the winding turns with it.</param>
        public static string Obj(Vector3 offset = default, WingSide side = WingSide.Right) => Obj((offset.x, offset.y, offset.z), side);

        /// <summary>The elliptical wing as an OBJ file, moved in double precision.</summary>
        public static string Obj((double X, double Y, double Z) offset, WingSide side = WingSide.Right)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            var text = new StringBuilder("# a wing\n");
            foreach (Vector3 position in surface.positions)
            {
                Vector3 there = Mirrored(position, side);
                text.AppendFormat(
                    CultureInfo.InvariantCulture, "v {0:R} {1:R} {2:R}\n", there.x + offset.X, there.y + offset.Y, there.z + offset.Z);
            }

            for (int k = 0; k < surface.triangles.Length; k += 3)
            {
                int a = surface.triangles[k] + 1, b = surface.triangles[k + 1] + 1, c = surface.triangles[k + 2] + 1;
                text.AppendLine(side == WingSide.Right ? $"f {a} {b} {c}" : $"f {a} {c} {b}");
            }

            return text.ToString();
        }

        /// <summary>Skeleton of the wing as JSON.</summary>
        public static string Skeleton(WingSide side = WingSide.Right, int chains = 5, bool unequal = false)
        {
            WingSkeleton skeleton = TestWings.Fan(chains);
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int j = 0; j < chain.joints.Length; j++)
                    chain.joints[j] = Mirrored(chain.joints[j], side);
            }

            skeleton.SpanAxis = Mirrored(Vector3.right, side);
            if (unequal)
                skeleton.Chains[1] = new JointChain(new[] { skeleton.GetJoint(1, 0), skeleton.GetJoint(1, 1), skeleton.GetJoint(1, 2) });
            return SkeletonJson.Write(skeleton);
        }

        private static Vector3 Mirrored(Vector3 v, WingSide side) => side == WingSide.Right ? v : new Vector3(-v.x, v.y, v.z);
    }
}
