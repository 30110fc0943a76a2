using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>Plays a binary glTF file with one mesh as its specification says: nodes, skins and shapes.</summary>
    internal sealed class GltfPlayer
    {
        private readonly GlbFile m_File;
        private readonly JsonElement[] m_Nodes;
        private readonly JsonElement m_Primitive;

        public GltfPlayer(byte[] file)
        {
            m_File = new GlbFile(file);
            m_Nodes = m_File.Root.GetProperty("nodes").EnumerateArray().ToArray();
            m_Primitive = m_File.Root.GetProperty("meshes")[0].GetProperty("primitives")[0];
        }

        /// <summary>The mesh at a time of an animation, seconds.</summary>
        public (float3[] Positions, float3[] Normals) Play(string animation, double time)
        {
            Dictionary<(int, string), double[]> values = Values(animation, time);
            JsonElement attributes = m_Primitive.GetProperty("attributes");
            float3[] positions = Vectors(attributes, "POSITION"), normals = Vectors(attributes, "NORMAL");
            int mesh = Array.FindIndex(m_Nodes, node => node.TryGetProperty("mesh", out _));
            if (values.TryGetValue((mesh, "weights"), out double[] weights))
                Morph(weights, positions, normals);
            if (m_Nodes[mesh].TryGetProperty("skin", out JsonElement skin))
                Skin(m_File.Root.GetProperty("skins")[skin.GetInt32()], attributes, values, positions, normals);
            return (positions, normals.Select(normal => math.normalize(normal)).ToArray());
        }

        /// <summary>Seconds of an animation.</summary>
        public double Length(string animation) =>
            m_File.Read(Animation(animation).GetProperty("samplers")[0].GetProperty("input").GetInt32()).Last();

        private JsonElement Animation(string name) =>
            m_File.Root.GetProperty("animations").EnumerateArray().Single(animation => animation.GetProperty("name").GetString() == name);

        private Dictionary<(int, string), double[]> Values(string name, double time)
        {
            JsonElement animation = Animation(name);
            var values = new Dictionary<(int, string), double[]>();
            foreach (JsonElement channel in animation.GetProperty("channels").EnumerateArray())
            {
                JsonElement sampler = animation.GetProperty("samplers")[channel.GetProperty("sampler").GetInt32()];
                Assert.That(sampler.GetProperty("interpolation").GetString(), Is.EqualTo("LINEAR"));
                double[] times = m_File.Read(sampler.GetProperty("input").GetInt32()),
                    keys = m_File.Read(sampler.GetProperty("output").GetInt32());
                string path = channel.GetProperty("target").GetProperty("path").GetString();
                int after = Math.Clamp(Array.FindIndex(times, key => key >= time), 1, times.Length - 1), width = keys.Length / times.Length;
                double share = (time - times[after - 1]) / (times[after] - times[after - 1]);
                double[] from = keys[((after - 1) * width)..(after * width)], to = keys[(after * width)..((after + 1) * width)];
                values.Add((channel.GetProperty("target").GetProperty("node").GetInt32(), path),
                    path == "rotation" ? Turned(from, to, share) : from.Zip(to, (a, b) => a + share * (b - a)).ToArray());
            }

            return values;
        }

        // The shorter way round a great circle.
        private static double[] Turned(double[] from, double[] to, double share)
        {
            double cosine = from.Zip(to, (a, b) => a * b).Sum(), sign = cosine < 0 ? -1 : 1,
                angle = Math.Acos(Math.Min(1.0, Math.Abs(cosine)));
            double a = angle < 1e-6 ? 1 - share : Math.Sin((1 - share) * angle) / Math.Sin(angle),
                b = angle < 1e-6 ? share : Math.Sin(share * angle) / Math.Sin(angle);
            return from.Zip(to, (x, y) => a * x + sign * b * y).ToArray();
        }

        private void Morph(double[] weights, float3[] positions, float3[] normals)
        {
            JsonElement targets = m_Primitive.GetProperty("targets");
            for (int target = 0; target < weights.Length; target++)
            {
                if (weights[target] == 0.0)
                    continue;
                float3[] moved = Vectors(targets[target], "POSITION"), turned = Vectors(targets[target], "NORMAL");
                for (int k = 0; k < positions.Length; k++)
                {
                    positions[k] += (float)weights[target] * moved[k];
                    normals[k] += (float)weights[target] * turned[k];
                }
            }
        }

        private void Skin(
            JsonElement skin, JsonElement attributes, Dictionary<(int, string), double[]> values, float3[] positions, float3[] normals)
        {
            int[] joints = skin.GetProperty("joints").EnumerateArray().Select(joint => joint.GetInt32()).ToArray();
            double[] binds = m_File.Read(skin.GetProperty("inverseBindMatrices").GetInt32());
            float4x4[] matrices = joints.Select((node, k) => math.mul(Global(node, values), Matrix(binds, 16 * k))).ToArray();
            double[] of = m_File.Read(attributes.GetProperty("JOINTS_0").GetInt32()),
                weights = m_File.Read(attributes.GetProperty("WEIGHTS_0").GetInt32());
            for (int k = 0; k < positions.Length; k++)
            {
                float3 position = 0f, normal = 0f;
                for (int c = 4 * k; c < 4 * k + 4; c++)
                {
                    float4x4 matrix = matrices[(int)of[c]];
                    position += (float)weights[c] * math.mul(matrix, new float4(positions[k], 1f)).xyz;
                    normal += (float)weights[c] * math.mul(matrix, new float4(normals[k], 0f)).xyz;
                }

                positions[k] = position;
                normals[k] = normal;
            }
        }

        private float4x4 Global(int node, Dictionary<(int, string), double[]> values)
        {
            double[] place = Value(node, "translation", values, new double[3]),
                turn = Value(node, "rotation", values, new[] { 0.0, 0.0, 0.0, 1.0 });
            var rotation = new float3x3(new quaternion((float)turn[0], (float)turn[1], (float)turn[2], (float)turn[3]));
            var local = new float4x4(
                new float4(rotation.c0, 0f), new float4(rotation.c1, 0f), new float4(rotation.c2, 0f),
                new float4((float)place[0], (float)place[1], (float)place[2], 1f));
            int parent = Array.FindIndex(m_Nodes, candidate =>
                candidate.TryGetProperty("children", out JsonElement children)
                && children.EnumerateArray().Any(child => child.GetInt32() == node));
            return parent < 0 ? local : math.mul(Global(parent, values), local);
        }

        private double[] Value(int node, string path, Dictionary<(int, string), double[]> values, double[] none) =>
            values.TryGetValue((node, path), out double[] animated) ? animated
            : m_Nodes[node].TryGetProperty(path, out JsonElement rest)
            ? rest.EnumerateArray().Select(number => number.GetDouble()).ToArray() : none;

        private float3[] Vectors(JsonElement attributes, string name) => m_File.ReadVectors(attributes.GetProperty(name).GetInt32());

        private static float4x4 Matrix(double[] numbers, int at)
        {
            var matrix = new float4x4();
            for (int k = 0; k < 16; k++)
                matrix[k / 4][k % 4] = (float)numbers[at + k];
            return matrix;
        }
    }
}
