using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>All meshes of an insect in the insect's own space, one behind the other, and the wings on them.</summary>
    internal sealed class DrawnInsect : IDisposable
    {
        private readonly InsectWings m_Insect;
        private readonly List<Vector3> m_Positions = new List<Vector3>(), m_Normals = new List<Vector3>();
        private readonly List<Vector2> m_Uvs = new List<Vector2>();
        private readonly List<Color32> m_Colours = new List<Color32>();
        private readonly Dictionary<Renderer, int> m_Starts = new Dictionary<Renderer, int>();
        private readonly List<List<int>> m_Triangles = new List<List<int>>();
        private readonly List<BakedPart> m_Parts = new List<BakedPart>();
        private readonly List<DrawnAbdomen> m_Abdomens = new List<DrawnAbdomen>();

        /// <exception cref="BakeException">The insect has a problem; the message says which.</exception>
        public DrawnInsect(InsectWings insect)
        {
            m_Insect = insect;
            InsectProblem problem = insect.FindProblem();
            if (problem.IsProblem)
                throw new BakeException(problem.Of(insect.name).Message);
            try
            {
                foreach (Wing wing in insect.Wings)
                    Wings.Add(Rig(wing, Wings.Count));
                foreach (Renderer renderer in DrawnRenderers.Under(insect.transform, false))
                    Append(renderer);
                foreach (DrawnWing wing in Wings)
                {
                    if (!m_Starts.ContainsKey(wing.Renderer))
                    {
                        throw new BakeException($"'{insect.name}' has a wing that is not drawn: show the renderer '{wing.Renderer.name}', "
                            + "below the insect and in its first level of detail, or take it off the list of wings.");
                    }
                }
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Wings in the order of the insect's list.</summary>
        public List<DrawnWing> Wings { get; } = new List<DrawnWing>();

        /// <summary>Abdomens that swing with the beat.</summary>
        public IReadOnlyList<DrawnAbdomen> Abdomens => m_Abdomens;

        /// <summary>The whole surface at rest.</summary>
        public BakedSurface Surface()
        {
            var parts = new List<BakedPart>();
            for (int k = 0; k < m_Parts.Count; k++)
                parts.Add(new BakedPart(m_Parts[k].Name, m_Parts[k].Material, m_Parts[k].HasColours, m_Triangles[k].ToArray()));
            return new BakedSurface
            {
                Positions = m_Positions.ToArray(),
                Normals = m_Normals.ToArray(),
                Uvs = m_Uvs.ToArray(),
                Colours = m_Colours.ToArray(),
                Parts = parts,
            };
        }

        /// <summary>Vertices of the surface that a wing's rig moves, in the rig's order.</summary>
        public int[] VerticesOf(DrawnWing wing) => Array.ConvertAll(wing.Selection.vertices, vertex => m_Starts[wing.Renderer] + vertex);

        /// <summary>Frees the rigs.</summary>
        public void Dispose()
        {
            foreach (DrawnWing wing in Wings)
                wing.Rig.Release();
            Wings.Clear();
        }

        private DrawnWing Rig(Wing wing, int index)
        {
            MeshFilter filter = InsectCheck.FilterOf(wing);
            Mesh mesh = InsectCheck.MeshOf(wing, filter);
            var parts = new RiggedParts(mesh, new AutomaticSkeleton(m_Insect.transform, filter.transform), m_Insect.Patches);
            RiggedPart[] rigged = parts.Build(new[] { wing }, new List<int> { index }, out InsectProblem problem);
            if (rigged == null)
                throw new BakeException(problem.Of(m_Insect.name).Message);
            return new DrawnWing(wing, rigged[0], ToInsect(filter.transform));
        }

        private void Append(Renderer renderer)
        {
            Mesh mesh = LivingMeshes.SourceOf(DrawnRenderers.MeshOf(renderer));
            if (!mesh.isReadable)
                throw new BakeException($"Mesh '{mesh.name}' is not readable: turn on Read/Write in its import settings.");
            int start = m_Positions.Count, count = mesh.vertexCount;
            m_Starts.Add(renderer, start);
            Matrix4x4 toInsect = ToInsect(renderer.transform);
            AbdomenSwing swing = renderer.GetComponentInParent<AbdomenSwing>(true);
            if (swing != null && swing.enabled && swing.transform.IsChildOf(m_Insect.transform))
                m_Abdomens.Add(new DrawnAbdomen(swing, ToInsect(swing.transform), ToInsect(swing.transform.parent), start, count));
            foreach (Vector3 position in mesh.vertices)
                m_Positions.Add(toInsect.MultiplyPoint3x4(position));
            AppendNormals(mesh, new NormalTransform(toInsect), count);
            Vector2[] uvs = mesh.uv;
            m_Uvs.AddRange(uvs.Length == count ? uvs : new Vector2[count]);
            Color32[] colours = mesh.colors32;
            bool hasColours = colours.Length == count;
            for (int vertex = 0; vertex < count; vertex++)
                m_Colours.Add(hasColours ? colours[vertex] : new Color32(255, 255, 255, 255));
            Material[] materials = System.Array.ConvertAll(renderer.sharedMaterials, SkinMaterials.SourceOf);
            for (int submesh = 0; submesh < mesh.subMeshCount; submesh++)
            {
                if (mesh.GetTopology(submesh) != MeshTopology.Triangles)
                    continue;
                Material material = submesh < materials.Length ? materials[submesh] : null;
                AppendTriangles(PartOf(renderer.name, material, hasColours), mesh.GetTriangles(submesh), start, toInsect.determinant < 0f);
            }
        }

        private void AppendNormals(Mesh mesh, in NormalTransform toInsect, int count)
        {
            Vector3[] normals = mesh.normals;
            if (normals.Length != count)
                throw new BakeException($"Mesh '{mesh.name}' has no normals: import it with normals, or recalculate them.");
            foreach (Vector3 normal in normals)
                m_Normals.Add(toInsect.Apply(normal));
        }

        private List<int> PartOf(string name, Material material, bool hasColours)
        {
            int part = m_Parts.FindIndex(known => ReferenceEquals(known.Material, material) && known.HasColours == hasColours);
            if (part < 0)
            {
                part = m_Parts.Count;
                m_Parts.Add(new BakedPart(name, material, hasColours, Array.Empty<int>()));
                m_Triangles.Add(new List<int>());
            }

            return m_Triangles[part];
        }

        private static void AppendTriangles(List<int> triangles, int[] corners, int start, bool turned)
        {
            for (int corner = 0; corner < corners.Length; corner += 3)
            {
                triangles.Add(start + corners[corner]);
                triangles.Add(start + corners[corner + (turned ? 2 : 1)]);
                triangles.Add(start + corners[corner + (turned ? 1 : 2)]);
            }
        }

        // Not by way of the world, where places are coarse far from the origin.
        private Matrix4x4 ToInsect(Transform mesh)
        {
            Transform root = m_Insect.transform;
            if (!mesh.IsChildOf(root))
                return root.worldToLocalMatrix * mesh.localToWorldMatrix;
            Matrix4x4 matrix = Matrix4x4.identity;
            for (Transform at = mesh; at != root; at = at.parent)
                matrix = Matrix4x4.TRS(at.localPosition, at.localRotation, at.localScale) * matrix;
            return matrix;
        }
    }
}
