using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Texture and materials of the wings that the graphics card deforms.</summary>
    internal sealed class GpuSkins : IDisposable
    {
        private readonly HashSet<IJointOwner> m_Wings = new HashSet<IJointOwner>();
        private readonly List<IJointOwner> m_Unplaced = new List<IJointOwner>();
        private int m_Version;

        public GpuSkins()
        {
            Table = new SkinTable(SystemInfo.maxTextureSize);
            Materials = new SkinMaterials(Table);
        }

        /// <summary>Transforms of the joints.</summary>
        public SkinTable Table { get; }

        /// <summary>Copies of the insects' materials.</summary>
        public SkinMaterials Materials { get; }

        /// <summary>Properties of the renderer that is looked at.</summary>
        public MaterialPropertyBlock Properties { get; } = new MaterialPropertyBlock();

        /// <summary>Finds what keeps the graphics card from deforming the wings that a renderer draws.</summary>
        /// <returns>Null where nothing does; else the reason, which names the object.</returns>
        public static string FindObstacle(Renderer renderer)
        {
            if (!SystemInfo.SupportsTextureFormat(TextureFormat.RGBAFloat))
                return "the graphics device reads no textures of 32-bit floats";
            Material[] materials = renderer.sharedMaterials;
            if (materials.Length == 0)
                return $"'{renderer.name}' has no material";
            foreach (Material material in materials)
            {
                if (material == null)
                    return $"'{renderer.name}' lacks a material";
                if (!SkinMaterials.CanDeform(material))
                {
                    return $"the shader '{material.shader.name}' of '{renderer.name}' deforms no wings: it has no property "
                        + $"{SkinMaterials.Map} and keyword {SkinMaterials.Keyword}";
                }
            }

            return renderer.TryGetComponent(out MeshCollider _) ? $"a MeshCollider on '{renderer.name}' reads the vertices" : null;
        }

        /// <summary>Adds wings, whose joints get their place in the texture by <see cref="PlaceJoints"/>.</summary>
        public void Add(IJointOwner wings)
        {
            m_Wings.Add(wings);
            m_Unplaced.Add(wings);
        }

        /// <summary>Removes wings.</summary>
        public void Remove(IJointOwner wings)
        {
            m_Wings.Remove(wings);
            m_Unplaced.Remove(wings);
        }

        /// <summary>Lets the jobs write the joints of new wings into the texture, and of all once it is another one.</summary>
        public void PlaceJoints(WingWorld world)
        {
            if (m_Version != Table.Version)
            {
                m_Version = Table.Version;
                m_Unplaced.Clear();
                m_Unplaced.AddRange(m_Wings);
            }

            foreach (IJointOwner wings in m_Unplaced)
                wings.PlaceJoints(world);
            m_Unplaced.Clear();
        }

        /// <summary>Begins a picture, before its transforms are computed.</summary>
        public void BeginPicture(WingWorld world)
        {
            Table.Begin();
            PlaceJoints(world);
        }

        /// <summary>Sends the transforms of a picture to the graphics card.</summary>
        public void EndPicture()
        {
            Table.End();
            Materials.Refresh();
        }

        public void Dispose()
        {
            Materials.Dispose();
            Table.Dispose();
        }
    }
}
