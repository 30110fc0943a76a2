using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>
    /// Plays an OpenVAT folder as the open importers' shaders do, in glTF's axes: texture coordinates from the top, frames downwards,
    /// Blender's axes turned.
    /// </summary>
    internal sealed class VatReader
    {
        private readonly WidePng m_Positions, m_Normals;
        private readonly float3 m_Min, m_Max;
        private readonly double[] m_Places;
        private readonly float3[] m_Rest;
        private readonly JsonElement m_Info;

        public VatReader(string folder, string name)
        {
            m_Positions = new WidePng(File.ReadAllBytes(Path.Combine(folder, name + ".png")));
            string normals = Path.Combine(folder, name + "-vnrm.png");
            IsPacked = !File.Exists(normals);
            m_Normals = IsPacked ? m_Positions : new WidePng(File.ReadAllBytes(normals));
            m_Info = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, name + "-remap_info.json"))).RootElement;
            JsonElement remap = m_Info.GetProperty("os-remap");
            m_Min = Vector(remap.GetProperty("Min"));
            m_Max = Vector(remap.GetProperty("Max"));
            Frames = remap.GetProperty("Frames").GetInt32();
            Mesh = new GlbFile(File.ReadAllBytes(Path.Combine(folder, name + ".glb")));
            JsonElement attributes = Mesh.Root.GetProperty("meshes")[0].GetProperty("primitives")[0].GetProperty("attributes");
            m_Rest = Mesh.ReadVectors(attributes.GetProperty("POSITION").GetInt32());
            m_Places = Mesh.Read(attributes.GetProperty("TEXCOORD_1").GetInt32());
        }

        public GlbFile Mesh { get; }

        public float3 Least => m_Min;

        public float3 Most => m_Max;

        public bool IsPacked { get; }

        public int Frames { get; }

        public int VertexCount => m_Rest.Length;

        public int Height => m_Positions.Height;

        public int Width => m_Positions.Width;

        /// <summary>The first and the last row of a clip, and its frames a second.</summary>
        public (int Start, int End, double Rate) Clip(string name)
        {
            JsonElement clip = m_Info.GetProperty("animations").GetProperty(name);
            Assert.That(clip.GetProperty("looping").GetBoolean(), Is.True);
            return (clip.GetProperty("startFrame").GetInt32(), clip.GetProperty("endFrame").GetInt32(), clip.GetProperty("framerate")
                .GetDouble());
        }

        /// <summary>The mesh at a place between two rows.</summary>
        public (float3[] Positions, float3[] Normals) At(double frame)
        {
            int before = (int)Math.Floor(frame), after = Math.Min(before + 1, Frames - 1);
            float share = (float)(frame - before);
            var positions = new float3[VertexCount];
            var normals = new float3[VertexCount];
            double shift = IsPacked ? 0.5 : 0.0;
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                float3 offset = math.lerp(Sample(m_Positions, vertex, before, 0.0), Sample(m_Positions, vertex, after, 0.0), share);
                positions[vertex] = m_Rest[vertex] + Turned(m_Min + offset * (m_Max - m_Min));
                float3 normal = math.lerp(Sample(m_Normals, vertex, before, shift), Sample(m_Normals, vertex, after, shift), share);
                normals[vertex] = math.normalize(Turned(2f * normal - 1f));
            }

            return (positions, normals);
        }

        private float3 Sample(WidePng picture, int vertex, int frame, double shift)
        {
            double u = m_Places[2 * vertex], v = m_Places[2 * vertex + 1] + (double)frame / picture.Height + shift;
            int column = (int)Math.Floor(u * picture.Width), row = (int)Math.Floor(v * picture.Height);
            if (!(Math.Abs(v * picture.Height - row - 0.5) < 0.01))
                Assert.Fail("not the middle of a pixel");
            return new float3((float)picture[column, row, 0], (float)picture[column, row, 1], (float)picture[column, row, 2]);
        }

        // Blender's axes to those of glTF.
        private static float3 Turned(float3 blender) => new float3(blender.x, blender.z, -blender.y);

        private static float3 Vector(JsonElement list)
        {
            float[] numbers = list.EnumerateArray().Select(number => number.GetSingle()).ToArray();
            return new float3(numbers[0], numbers[1], numbers[2]);
        }
    }
}
