using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Texture and materials of the wings that the graphics card deforms.</summary>
    internal sealed class GpuSkins : IDisposable
    {
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

        /// <summary>Begins a picture, before its transforms are computed.</summary>
        public void BeginPicture() => Table.Begin();

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
