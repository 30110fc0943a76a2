using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Remembers, for this user, the mesh on which the inspector shows a skeleton. The skeleton itself refers to no mesh.
    /// </summary>
    internal static class SkeletonMeshMemory
    {
        private const string k_Prefix = "Alate.SkeletonMesh.";

        /// <summary>Mesh of a skeleton; null where none was chosen or it is gone.</summary>
        public static Mesh Get(WingSkeleton skeleton)
        {
            string known = EditorPrefs.GetString(KeyOf(skeleton), "");
            return GlobalObjectId.TryParse(known, out GlobalObjectId id)
                ? GlobalObjectId.GlobalObjectIdentifierToObjectSlow(id) as Mesh
                : null;
        }

        /// <summary>Remembers a mesh, or forgets it where it is null.</summary>
        public static void Set(WingSkeleton skeleton, Mesh mesh)
        {
            if (mesh == null)
                EditorPrefs.DeleteKey(KeyOf(skeleton));
            else
                EditorPrefs.SetString(KeyOf(skeleton), GlobalObjectId.GetGlobalObjectIdSlow(mesh).ToString());
        }

        private static string KeyOf(WingSkeleton skeleton) => k_Prefix + GlobalObjectId.GetGlobalObjectIdSlow(skeleton);
    }
}
