using System;
using System.Collections.Generic;
using Alate.Crowds;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Crowds
{
    /// <summary>
    /// A bake made by hand: two plane wings along X with one fold each, and a small body between that is an abdomen; every number of every
    /// vertex differs.
    /// </summary>
    internal static class PlainBake
    {
        public const float WingLength = 2f;

        private const int k_Columns = 8, k_Rows = 4, k_WingVertices = (k_Columns + 1) * (k_Rows + 1), k_BodyVertices = 4;

        /// <param name="frames">Frames of each clip.</param>
        public static InsectBake Make(params int[] frames)
        {
            var bake = new InsectBake
            {
                Name = "plain",
                Surface = Surface(),
                Wings = new[] { Wing("right", WingSide.Right, 0), Wing("left", WingSide.Left, 1) },
                MetresPerUnit = 0.025f,
                WingLength = WingLength,
                Abdomens = new[]
                {
                    new BakedAbdomen { Name = "abdomen", FirstVertex = 2 * k_WingVertices, VertexCount = k_BodyVertices, Joint = 4 },
                },
                JointCount = 5,
            };
            var clips = new List<BakedClip>();
            for (int clip = 0; clip < frames.Length; clip++)
                clips.Add(Clip(bake, clip, frames[clip]));
            bake.Clips = clips;
            return bake;
        }

        private static BakedSurface Surface()
        {
            var positions = new Vector3[2 * k_WingVertices + k_BodyVertices];
            var wings = new List<int>();
            int[] body = { 0, 2, 1, 1, 2, 3 };
            for (int wing = 0; wing < 2; wing++)
            {
                float side = wing == 0 ? 1f : -1f;
                int first = wing * k_WingVertices;
                for (int k = 0; k < k_WingVertices; k++)
                {
                    positions[first + k] = new Vector3(
                        side * (0.1f + WingLength * (k / (k_Rows + 1)) / k_Columns), 0f, 0.5f - (float)(k % (k_Rows + 1)) / k_Rows);
                }
                for (int column = 0; column < k_Columns; column++)
                {
                    for (int row = 0; row < k_Rows; row++)
                    {
                        int a = first + column * (k_Rows + 1) + row, b = a + k_Rows + 1;
                        wings.AddRange(wing == 0 ? new[] { a, b, b + 1, a, b + 1, a + 1 } : new[] { a, b + 1, b, a, a + 1, b + 1 });
                    }
                }
            }

            for (int k = 0; k < k_BodyVertices; k++)
                positions[2 * k_WingVertices + k] = new Vector3(k % 2 == 0 ? -0.08f : 0.08f, -0.05f, k < 2 ? -0.9f : 0.9f);
            var uvs = new Vector2[positions.Length];
            var normals = new Vector3[positions.Length];
            var colours = new Color32[positions.Length];
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                uvs[vertex] = new Vector2(vertex / 128f, 1f - vertex / 256f);
                normals[vertex] = new Vector3(0.1f * Mathf.Sin(vertex), 1f, 0.1f * Mathf.Cos(vertex)).normalized;
                colours[vertex] = new Color32((byte)vertex, (byte)(2 * vertex), (byte)(255 - vertex), (byte)(100 + vertex));
            }

            return new BakedSurface
            {
                Positions = positions,
                Normals = normals,
                Uvs = uvs,
                Colours = colours,
                Parts = new[] { new BakedPart("wings", null, true, wings.ToArray()),
                    new BakedPart("body", null, false, Array.ConvertAll(body, corner => 2 * k_WingVertices + corner)) },
            };
        }

        private static BakedWing Wing(string name, WingSide side, int index) => new BakedWing
        {
            Name = name,
            Side = side,
            Length = WingLength,
            Vertices = From(index * k_WingVertices),
            FirstJoint = 2 * index,
            JointsPerChain = 2,
            RestJoints = new[] { new float3(index == 0 ? 0.1f : -0.1f, 0f, 0f), new float3(index == 0 ? 1.1f : -1.1f, 0f, 0f) },
            VertexJoints = Array.ConvertAll(From(0), k => new int4(k % 2, 1 - k % 2, 0, 0)),
            VertexWeights = Array.ConvertAll(From(0), k => new float4(1f - k / 100f, k / 100f, 0f, 0f)),
        };

        private static int[] From(int first)
        {
            int[] numbers = new int[k_WingVertices];
            for (int k = 0; k < numbers.Length; k++)
                numbers[k] = first + k;
            return numbers;
        }

        private static BakedClip Clip(InsectBake bake, int clip, int count)
        {
            var frames = new List<BakedFrame>();
            for (int frame = 0; frame < count; frame++)
                frames.Add(Frame(bake, 0.4f * math.sin(2f * math.PI * frame / count + clip)));
            return new BakedClip
            {
                Motion = new BakeMotion("clip " + clip)
                {
                    Roll = 0.1f * (clip + 1),
                    Steering = new InsectSteering { frequencyScale = 1f, amplitudeScale = 0.5f, meanFlap = 3f + clip },
                },
                Frequency = 10f + clip,
                Velocity = new float3(0.1f, 0.2f, 3f + clip),
                AngularVelocity = new float3(0.01f, 0.5f + clip, 0.02f),
                Attitude = math.mul(quaternion.RotateX(-0.2f), quaternion.RotateZ(0.1f * clip)),
                RightBeat = clip == 0 ? (WingDrive?)null : Beat(clip),
                LeftBeat = clip == 0 ? (WingDrive?)null : Beat(clip + 10),
                Frames = frames,
                Error = new BakeError { between = 0.001f * (clip + 1), closure = 0.002f, linearSkin = 0.003f, normalBetween = 0.4f },
            };
        }

        private static WingDrive Beat(int number) => new WingDrive
        {
            frequency = number,
            amplitude = 0.1f
            * number,
            meanFlap = 0.2f,
            meanSweep = 0.3f,
            meanFeather = 0.4f,
            tilt = 0.05f * number
        };

        // Each wing turns about its root by an angle, as a plane: blends of its corners are exact.
        private static BakedFrame Frame(InsectBake bake, float angle)
        {
            BakedSurface surface = bake.Surface;
            var frame = new BakedFrame(surface.VertexCount, 5);
            for (int vertex = 0; vertex < surface.VertexCount; vertex++)
            {
                float side = vertex < k_WingVertices ? 1f : vertex < 2 * k_WingVertices ? -1f : 0f;
                var turn = quaternion.RotateZ(side * angle);
                var root = new float3(0.1f * side, 0f, 0f);
                frame.Positions[vertex] = root + math.rotate(turn, (float3)surface.Positions[vertex] - root);
                frame.Normals[vertex] = math.rotate(turn, surface.Normals[vertex]);
            }

            for (int joint = 0; joint < 5; joint++)
                frame.Joints[joint] = new BakedJoint(new float3(joint, angle, 0f), quaternion.RotateZ(angle));
            return frame;
        }
    }
}
