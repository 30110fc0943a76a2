using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Makes the mesh and the object of one wing.</summary>
    internal sealed class SkinnedWingBuilder
    {
        private readonly SkinnedMeshRenderer m_Source;
        private readonly string m_Name;

        // The submeshes of the source that the wing has triangles of, and their corners.
        private readonly List<int> m_Places = new List<int>();
        private readonly List<int[]> m_Corners = new List<int[]>();

        public SkinnedWingBuilder(SkinnedMeshRenderer source, SkinnedWing wing, bool namesPair)
        {
            m_Source = source;
            m_Name = namesPair ? $"{wing.place.pair} Wing {wing.place.Side}" : $"Wing {wing.place.Side}";
            for (int submesh = 0; submesh < wing.submeshes.Length; submesh++)
            {
                if (wing.submeshes[submesh].Length == 0)
                    continue;
                m_Places.Add(submesh);
                m_Corners.Add(wing.submeshes[submesh]);
            }
        }

        /// <summary>
        /// Makes the wing's mesh in the space of a bone, with a submesh for each of the source's that it has triangles of.
        /// </summary>
        public Mesh Mesh(BlendedShape shape, Matrix4x4 bind)
        {
            Mesh mesh = WingMeshCut.Cut(m_Source.sharedMesh, shape, m_Corners, bind);
            mesh.name = $"{m_Source.sharedMesh.name} {m_Name}";
            return mesh;
        }

        /// <summary>Makes an object under a bone that draws the mesh as the source would.</summary>
        public MeshRenderer Renderer(Transform bone, Mesh mesh)
        {
            var made = new GameObject(m_Name);
            made.transform.SetParent(bone, false);
            made.SetActive(m_Source.gameObject.activeSelf);
            made.AddComponent<MeshFilter>().sharedMesh = mesh;
            MeshRenderer renderer = made.AddComponent<MeshRenderer>();
            renderer.sharedMaterials = Materials(m_Source.sharedMaterials);
            RendererSettings.Copy(m_Source, renderer);
            for (int place = 0; place < m_Places.Count && m_Places[place] < m_Source.sharedMaterials.Length; place++)
                RendererSettings.CopyProperties(m_Source, m_Places[place], renderer, place);
            return renderer;
        }

        // Materials beyond the last submesh are drawn over it, so they go where it goes.
        private Material[] Materials(Material[] all)
        {
            int last = m_Source.sharedMesh.subMeshCount - 1;
            List<Material> own = m_Places.ConvertAll(submesh => submesh < all.Length ? all[submesh] : null);
            for (int extra = last + 1; extra < all.Length && m_Places.Contains(last); extra++)
                own.Add(all[extra]);
            return own.ToArray();
        }
    }
}
