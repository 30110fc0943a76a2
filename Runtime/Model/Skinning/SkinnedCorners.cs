using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Vertices of a wing as a vertex shader deforms them: which joints move each, and its normal at rest.</summary>
    internal static unsafe class SkinnedCorners
    {
        /// <summary>Writes the vertices of a wing.</summary>
        /// <param name="rig">The wing's.</param>
        /// <param name="start">Its first vertex in the lists.</param>
        /// <param name="firstJoint">Its first joint in the block of transforms.</param>
        /// <param name="normals">[vertex] At rest, mesh space.</param>
        /// <param name="joints">
        /// [vertex] First joint of the cell, number of joints from there to the next chain's, place across and along the chains, 0 to 1.
        /// </param>
        public static void Write(WingRig rig, int start, int firstJoint, Vector3[] normals, List<Vector4> joints)
        {
            RigView view = rig.View;
            for (int cell = 0; cell < view.cellCount; cell++)
            {
                int joint = firstJoint + cell + cell / (view.jointsPerChain - 1);
                SkinCell range = view.skinCells[cell];
                for (SkinQuad* quad = view.skinQuads + range.firstQuad; quad < view.skinQuads + range.firstQuad + range.quadCount; quad++)
                {
                    for (int lane = 0; lane < WingPack.Lanes; lane++)
                    {
                        int vertex = start + quad->target[lane];
                        joints[vertex] = new Vector4(joint, view.jointsPerChain, quad->u[lane], quad->v[lane]);
                        normals[vertex] = new Vector3(quad->nx[lane], quad->ny[lane], quad->nz[lane]);
                    }
                }
            }
        }
    }
}
