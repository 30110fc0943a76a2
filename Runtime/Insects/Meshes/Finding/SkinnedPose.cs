using UnityEngine;

namespace Alate
{
    /// <summary>Placement of a skinned mesh in the world.</summary>
    internal static class SkinnedPose
    {
        /// <summary>
        /// Matrix from the mesh to the world by a bone, which is equal for all bones in the bind pose: by the root bone if it moves the
        /// mesh, else by the first. The renderer's own matrix for a mesh without bones.
        /// </summary>
        public static Matrix4x4 ToWorld(SkinnedMeshRenderer renderer)
        {
            Transform[] bones = renderer.bones;
            Matrix4x4[] binds = renderer.sharedMesh.bindposes;
            int chosen = System.Array.FindIndex(bones, bone => bone != null && bone == renderer.rootBone);
            if (chosen < 0 || chosen >= binds.Length)
                chosen = System.Array.FindIndex(bones, bone => bone != null);
            return chosen >= 0 && chosen < binds.Length
                ? bones[chosen].localToWorldMatrix * binds[chosen]
                : renderer.transform.localToWorldMatrix;
        }
    }
}
