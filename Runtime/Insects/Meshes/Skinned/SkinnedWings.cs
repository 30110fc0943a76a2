using UnityEngine;

namespace Alate
{
    /// <summary>Finds the triangles of a skinned mesh that are wings.</summary>
    internal sealed class SkinnedWings
    {
        private readonly SkinnedMeshRenderer m_Source;
        private readonly Mesh m_Mesh;
        private readonly Transform m_Insect;
        private readonly RendererNames m_Names;

        private SkinnedWings(SkinnedMeshRenderer source, Transform insect)
        {
            m_Source = source;
            m_Mesh = source.sharedMesh;
            m_Insect = insect;
            m_Names = new RendererNames(source, m_Mesh, insect);
        }

        /// <summary>
        /// The triangles of wings: all if the renderer is called so, else those of such materials, then bones, else thin mirrored parts.
        /// </summary>
        /// <param name="source">A renderer with a readable mesh.</param>
        /// <param name="insect">Its root: X right, Y up, Z ahead.</param>
        public static TriangleSet Find(SkinnedMeshRenderer source, Transform insect)
        {
            var wings = new SkinnedWings(source, insect);
            var found = new TriangleSet(source.sharedMesh);
            if (wings.m_Names.IsCase)
                return found;
            wings.AddNamed(found);
            if (found.IsEmpty)
                wings.AddMovedByWingBones(found);
            if (found.IsEmpty)
                wings.AddMirrored(found);
            return found;
        }

        /// <summary>Returns true where a renderer draws wings; for a mesh that cannot be read, names decide.</summary>
        public static bool IsIn(SkinnedMeshRenderer source, Transform insect)
        {
            if (source.sharedMesh.isReadable)
                return !Find(source, insect).IsEmpty;
            var names = new RendererNames(source, source.sharedMesh, insect);
            if (names.IsCase)
                return false;
            for (int submesh = 0; submesh < source.sharedMesh.subMeshCount; submesh++)
            {
                if (names.IsWing || names.Material(submesh).IsWing)
                    return true;
            }

            return System.Array.Exists(source.bones, bone => bone != null && WingName.Read(bone.name).NamesWing);
        }

        private void AddNamed(TriangleSet found) => found.Add((submesh, a, b, c) => m_Names.IsWing || m_Names.Material(submesh).IsWing);

        private void AddMovedByWingBones(TriangleSet found)
        {
            var bones = new WingBones(m_Source, m_Insect);
            if (bones.IsSkinned)
                found.Add((submesh, a, b, c) => bones.IsWing(a, b, c));
        }

        private void AddMirrored(TriangleSet found)
        {
            foreach (WingCandidate candidate in MirrorPairs.Of(WingCandidates.Of(m_Source, m_Mesh, m_Insect)))
                found.Add(candidate.part, candidate.submesh, candidate.point);
        }
    }
}
