using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>Texture, meshes and materials of a baked insect.</summary>
    internal sealed class BakedInsectParts
    {
        /// <summary>Keyword and texture of shaders that show baked wings.</summary>
        public const string Keyword = "_BAKED", TextureName = "_BakeMap";

        /// <summary>
        /// Height on the screen of an insect of one triangle whose edges span eight pixels of a thousand; it grows with the root of their
        /// number.
        /// </summary>
        private const float k_HeightOfOneTriangle = 0.01f;

        private readonly InsectBake m_Bake;
        private readonly BakeLayout m_Layout;
        private readonly Dictionary<int, int> m_ColumnOf = new Dictionary<int, int>();

        /// <exception cref="BakeException">The texture would be too large, or a shader cannot show baked wings.</exception>
        public BakedInsectParts(InsectBake bake, ReducedSurface[] reduced, int maxTextureSize)
        {
            m_Bake = bake;
            m_Layout = BakeLayout.Fit(reduced[0].Vertices.Length, bake.FrameCount, maxTextureSize, true);
            foreach (int vertex in reduced[0].Vertices)
                m_ColumnOf.Add(vertex, m_ColumnOf.Count);
            Materials = MakeMaterials();
            Texture = Paint(reduced[0].Vertices);
            Loops = Describe();
            Sizes = Array.ConvertAll(reduced, MakeSize);
            foreach (Material material in Materials)
                material.SetTexture(TextureName, Texture);
        }

        public Texture2D Texture { get; }

        public CrowdSize[] Sizes { get; }

        public Material[] Materials { get; }

        public CrowdLoop[] Loops { get; }

        // Rows from the lower left, as Unity counts them: positions below, normals above.
        private Texture2D Paint(int[] vertices)
        {
            var pixels = new Color[m_Layout.Width * m_Layout.Height];
            int row = 0;
            foreach (BakedClip clip in m_Bake.Clips)
            {
                foreach (BakedFrame frame in clip.Frames)
                {
                    foreach (int vertex in vertices)
                    {
                        int2 pixel = m_Layout.PixelOf(m_ColumnOf[vertex], row);
                        pixels[pixel.y * m_Layout.Width + pixel.x] = Pixel(frame.Positions[vertex]);
                        pixels[(pixel.y + m_Layout.NormalRows) * m_Layout.Width + pixel.x] = Pixel(frame.Normals[vertex]);
                    }

                    row++;
                }
            }

            var texture = new Texture2D(m_Layout.Width, m_Layout.Height, TextureFormat.RGBAHalf, false, true)
            {
                name = m_Bake.Name + " Loops",
                filterMode = FilterMode.Point,
                wrapMode = TextureWrapMode.Clamp,
            };
            texture.SetPixels(pixels);
            texture.Apply(false, false);
            return texture;
        }

        private static Color Pixel(float3 value) => new Color(value.x, value.y, value.z, 1f);

        private Material[] MakeMaterials()
        {
            var materials = new List<Material>();
            foreach (BakedPart part in m_Bake.Surface.Parts)
            {
                if (part.Material == null || !part.Material.HasProperty(TextureName))
                {
                    string shader = part.Material == null ? "no material" : $"the shader '{part.Material.shader.name}'";
                    materials.ForEach(ObjectEnd.Destroy);
                    throw new BakeException($"'{part.Name}' of '{m_Bake.Name}' has "
                        + $"{shader}, which cannot show baked wings: use Alate/Wing, in the built-in pipeline or URP.");
                }

                var material = new Material(part.Material) { name = part.Material.name + " Baked", enableInstancing = true };
                material.EnableKeyword(Keyword);
                materials.Add(material);
            }

            return materials.ToArray();
        }

        private CrowdLoop[] Describe()
        {
            var loops = new List<CrowdLoop>();
            int first = 0;
            foreach (BakedClip clip in m_Bake.Clips)
            {
                loops.Add(new CrowdLoop
                {
                    name = clip.Name,
                    firstFrame = first,
                    frames = clip.Frames.Count,
                    frequency = clip.Frequency,
                    velocity = clip.Velocity,
                    angularVelocity = clip.AngularVelocity,
                    attitude = clip.Attitude,
                    steering = clip.Motion.Steering,
                    roll = clip.Motion.Roll,
                    isFlown = clip.RightBeat.HasValue,
                    rightBeat = clip.RightBeat.GetValueOrDefault(),
                    leftBeat = clip.LeftBeat.GetValueOrDefault(),
                    error = clip.Error.between,
                });
                first += clip.Frames.Count;
            }

            return loops.ToArray();
        }

        private CrowdSize MakeSize(ReducedSurface reduced)
        {
            BakedSurface surface = m_Bake.Surface;
            int[] vertices = reduced.Vertices;
            var placeOf = new Dictionary<int, int>();
            foreach (int vertex in vertices)
                placeOf.Add(vertex, placeOf.Count);
            var mesh = new Mesh { name = $"{m_Bake.Name} {reduced.TriangleCount}", indexFormat = IndexFormat.UInt16 };
            mesh.vertices = Array.ConvertAll(vertices, vertex => surface.Positions[vertex]);
            mesh.normals = Array.ConvertAll(vertices, vertex => surface.Normals[vertex]);
            mesh.uv = Array.ConvertAll(vertices, vertex => surface.Uvs[vertex]);
            mesh.SetUVs(1, Array.ConvertAll(vertices, CoordinatesOf));
            mesh.colors32 = Array.ConvertAll(vertices, vertex => surface.Colours[vertex]);
            mesh.subMeshCount = reduced.Parts.Length;
            for (int part = 0; part < reduced.Parts.Length; part++)
                mesh.SetTriangles(Array.ConvertAll(reduced.Parts[part], vertex => placeOf[vertex]), part, false);
            mesh.bounds = m_Bake.Bounds;
            return new CrowdSize
            {
                mesh = mesh,
                triangles = reduced.TriangleCount,
                error = reduced.Error,
                screenHeight = k_HeightOfOneTriangle * Mathf.Sqrt(reduced.TriangleCount),
            };
        }

        private Vector2 CoordinatesOf(int vertex)
        {
            int2 pixel = m_Layout.PixelOf(m_ColumnOf[vertex], 0);
            return new Vector2((pixel.x + 0.5f) / m_Layout.Width, (pixel.y + 0.5f) / m_Layout.Height);
        }
    }
}
