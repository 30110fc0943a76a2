using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A right wing at rest that is a mesh, not an outline: its base at the origin, X to the tip, Y up, Z ahead, one unit long.
    /// </summary>
    internal sealed class MeshedWing
    {
        /// <param name="surface">The mesh; texture coordinates and colours are kept, normals computed.</param>
        /// <param name="chains">Chains of the skeleton in the space of the mesh.</param>
        public MeshedWing(SurfaceMesh surface, JointChain[] chains)
        {
            Surface = surface;
            Chains = chains;
        }

        /// <summary>The mesh.</summary>
        public SurfaceMesh Surface { get; }

        /// <summary>Chains of the skeleton, from leading to trailing edge.</summary>
        public JointChain[] Chains { get; }

        /// <summary>The mesh in another size.</summary>
        public SurfaceMesh CreateSurface(float scale, string name) => new SurfaceMesh
        {
            name = name,
            positions = Array.ConvertAll(Surface.positions, position => scale * position),
            normals = (Vector3[])Surface.normals?.Clone(),
            uvs = (Vector2[])Surface.uvs?.Clone(),
            colours = (Color32[])Surface.colours?.Clone(),
            triangles = (int[])Surface.triangles.Clone(),
        };

        /// <summary>The skeleton in another size.</summary>
        public WingSkeleton CreateSkeleton(float scale, WingSide side)
        {
            float x = side == WingSide.Right ? 1f : -1f;
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Hinge = Vector3.zero;
            skeleton.SpanAxis = new Vector3(x, 0f, 0f);
            skeleton.UpAxis = Vector3.up;
            skeleton.Chains = Array.ConvertAll(Chains, chain =>
            {
                JointChain placed = chain;
                placed.joints = Array.ConvertAll(
                    chain.joints, joint => new Vector3(x * scale * joint.x, scale * joint.y, scale * joint.z));
                return placed;
            });
            return skeleton;
        }
    }
}
