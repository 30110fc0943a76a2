using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>
    /// A baked insect as crowds draw it: a texture with its loops, meshes of 1 to 4 sizes, and materials. Made from an
    /// <see cref="InsectBake"/>. Its file is binary, whatever the project's asset serialization.
    /// </summary>
    [PreferBinarySerialization]
    public sealed class BakedInsect : ScriptableObject
    {
        [SerializeField] private Texture2D m_Texture;
        [SerializeField] private CrowdSize[] m_Sizes = Array.Empty<CrowdSize>();
        [SerializeField] private Material[] m_Materials = Array.Empty<Material>();
        [SerializeField] private CrowdLoop[] m_Loops = Array.Empty<CrowdLoop>();
        [SerializeField] private Bounds m_Bounds;
        [SerializeField] private float m_WingLength;

        /// <summary>Triangles of the meshes unless asked otherwise.</summary>
        public static IReadOnlyList<int> DefaultTriangles { get; } = new[] { 2000, 500, 160 };

        /// <summary>Positions of all vertices at all frames, normals in the upper half; half-floats.</summary>
        public Texture2D Texture => m_Texture;

        /// <summary>Meshes, the finest first.</summary>
        public IReadOnlyList<CrowdSize> Sizes => m_Sizes;

        /// <summary>[submesh] Materials.</summary>
        public IReadOnlyList<Material> Materials => m_Materials;

        /// <summary>Loops.</summary>
        public IReadOnlyList<CrowdLoop> Loops => m_Loops;

        /// <summary>Bounds of the insect over all loops, in its own space.</summary>
        public Bounds Bounds => m_Bounds;

        /// <summary>Length of the longest wing, units of the insect's space.</summary>
        public float WingLength => m_WingLength;

        /// <summary>Bytes of the texture.</summary>
        public long TextureBytes => m_Texture == null ? 0 : 8L * m_Texture.width * m_Texture.height;

        /// <summary>The loop of a name; −1 where there is none.</summary>
        public int IndexOf(string loop) =>
            Array.FindIndex(m_Loops, known => string.Equals(known.name, loop, StringComparison.OrdinalIgnoreCase));

        /// <summary>The loop of a number from 0; the last one where there is no such loop.</summary>
        internal CrowdLoop LoopAt(int loop) => m_Loops[loop >= 0 && loop < m_Loops.Length ? loop : m_Loops.Length - 1];

        /// <summary>Makes texture, meshes and materials of a bake. The caller owns them; <see cref="DestroyParts"/> frees them.</summary>
        /// <param name="bake">The insect.</param>
        /// <param name="triangles">Triangles of each mesh, descending; null takes <see cref="DefaultTriangles"/>.</param>
        /// <param name="maxTextureSize">Longest side of the texture, pixels.</param>
        /// <exception cref="ArgumentNullException">There is no bake.</exception>
        /// <exception cref="BakeException">The texture would be too large, or a material's shader cannot show baked wings; one
        /// line.</exception>
        public static BakedInsect Create(
            InsectBake bake, IReadOnlyList<int> triangles = null, int maxTextureSize = BakeLayout.DefaultMaxSize)
        {
            if (bake == null)
                throw new ArgumentNullException(nameof(bake));
            return Create(bake, ReducedSurface.Of(bake, triangles ?? DefaultTriangles), maxTextureSize);
        }

        /// <summary>Makes texture, meshes and materials of a bake whose smaller meshes are known.</summary>
        internal static BakedInsect Create(InsectBake bake, ReducedSurface[] reduced, int maxTextureSize = BakeLayout.DefaultMaxSize)
        {
            var parts = new BakedInsectParts(bake, reduced, maxTextureSize);
            BakedInsect made = CreateInstance<BakedInsect>();
            made.name = bake.Name + " Baked";
            made.m_Texture = parts.Texture;
            made.m_Sizes = parts.Sizes;
            made.m_Materials = parts.Materials;
            made.m_Loops = parts.Loops;
            made.m_Bounds = bake.Bounds;
            made.m_WingLength = bake.WingLength;
            return made;
        }

        /// <summary>
        /// Frees the copies of texture and meshes that a player's processor would keep beside those of the graphics device. In the editor
        /// they stay: assets are written from them.
        /// </summary>
        internal void FreeCopies()
        {
            if (Application.isEditor)
                return;
            if (m_Texture != null && m_Texture.isReadable)
                m_Texture.Apply(false, true);
            foreach (CrowdSize size in m_Sizes)
            {
                if (size.mesh != null && size.mesh.isReadable)
                    size.mesh.UploadMeshData(true);
            }
        }

        /// <summary>Destroys texture, meshes and materials; not for those that are saved as assets.</summary>
        public void DestroyParts()
        {
            ObjectEnd.Destroy(m_Texture);
            foreach (CrowdSize size in m_Sizes)
                ObjectEnd.Destroy(size.mesh);
            foreach (Material material in m_Materials)
                ObjectEnd.Destroy(material);
        }
    }
}
