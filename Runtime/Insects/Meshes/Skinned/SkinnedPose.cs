using UnityEngine;

namespace Alate
{
    /// <summary>Where a skinned mesh is.</summary>
    internal static class SkinnedPose
    {
        /// <summary>
        /// From the mesh to the world as a bone has it, which is the same for all bones in the bind pose: the root bone if it moves the
        /// mesh, else the first. The renderer's own place for a mesh without bones.
        /// </summary>
        public static Matrix4x4 ToWorld(SkinnedMeshRenderer renderer)
        {
            var bones = renderer.bones;
            var binds = renderer.sharedMesh.bindposes;
            var chosen = System.Array.FindIndex(bones, bone => bone != null && bone == renderer.rootBone);
            if (chosen < 0 || chosen >= binds.Length)
                chosen = System.Array.FindIndex(bones, bone => bone != null);
            return chosen >= 0 && chosen < binds.Length
                ? bones[chosen].localToWorldMatrix * binds[chosen]
                : renderer.transform.localToWorldMatrix;
        }
    }
}
