using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    public sealed class WeightTests : RigFixture
    {
        [Test]
        public void WeightsOfEveryVertex_AreAPartitionOfUnity()
        {
            WingRig rig = Bake();
            for (int k = 0; k < rig.VertexCount; k++)
            {
                Assert.That(math.cmin(rig.VertexWeights[k]), Is.GreaterThanOrEqualTo(0f));
                Assert.That(math.csum(rig.VertexWeights[k]), Is.EqualTo(1f).Within(1e-6f));
            }
        }

        [Test]
        public void WeightedRestJoints_AreTheVertex_WithinTheFan()
        {
            SurfaceMesh surface = TestWings.Rectangle();
            WingRig rig = Bake(TestWings.Lattice(), surface);
            for (int k = 0; k < rig.VertexCount; k++)
            {
                float3 mean = default;
                for (int c = 0; c < 4; c++)
                    mean += rig.VertexWeights[k][c] * rig.RestJoints[rig.VertexJoints[k][c]];
                Assert.That(math.distance(mean, rig.Frame.ToWing(surface.positions[k])), Is.LessThan(1e-6f));
            }
        }

        [Test]
        public void AVertexOnAJoint_FollowsThatJointAlone()
        {
            WingSkeleton skeleton = TestWings.Fan();
            SurfaceMesh surface = TestWings.Ellipse();
            for (int joint = 1; joint < 25; joint++)
                surface.positions[joint] = skeleton.GetJoint(joint / 5, joint % 5);
            WingRig rig = Bake(skeleton, surface);
            for (int joint = 1; joint < 25; joint++)
                Assert.That(Weights(rig, joint)[joint], Is.EqualTo(1f).Within(1e-4f), $"joint {joint}");
        }

        [Test]
        public void OnAChainBetweenTwoCells_TheForwardCellHasTheVertex()
        {
            WingRig rig = Bake(TestWings.Lattice(), TestWings.Rectangle(8, 8));

            // Column 3 lies between joints 1 and 2, row 4 on chain 2; the forward cell begins at chain 1.
            Assert.That(rig.VertexJoints[3 * 9 + 4], Is.EqualTo(new int4(6, 7, 11, 12)));
            Assert.That(math.distance(rig.VertexWeights[3 * 9 + 4], new float4(0f, 0f, 0.5f, 0.5f)), Is.LessThan(1e-6f));
        }

        [Test]
        public void AlongAnyWay_WeightsChangeNoFasterThanTheWay()
        {
            // A joint's weight falls from 1 to 0 over a cell; the narrowest lie at the roots, 0.05 wing lengths apart.
            const int k_Steps = 2000;
            const float k_Steepest = 45f;
            WingSkeleton skeleton = TestWings.Fan();
            var random = new Random(5);
            for (int way = 0; way < 20; way++)
            {
                // Way 0 is along the outline, beyond the fan; the others cross the wing.
                SurfaceMesh surface = Line(way == 0 ? (Func<float, Vector3>)Rim : Chord(random), k_Steps);
                WingRig rig = Bake(skeleton, surface);
                int first = rig.VertexCount - k_Steps - 1;
                float step = 0f, change = 0f;
                for (int k = first; k < rig.VertexCount - 1; k++)
                {
                    step = math.max(step, math.distance(surface.positions[k], surface.positions[k + 1]));
                    change = math.max(change, Change(Weights(rig, k), Weights(rig, k + 1)));
                }

                Assert.That(change, Is.LessThan(k_Steepest * step), $"way {way}");
            }
        }

        [Test]
        public void VerticesBeyondTheFan_KeepToTheNearestCell()
        {
            SurfaceMesh surface = TestWings.Rectangle();
            int last = surface.positions.Length - 1;
            surface.positions[last] = new Vector3(0.9f, 0.1f, 0.3f);
            WingRig rig = Bake(TestWings.Lattice(), surface);

            // 0.9 lies between joints 3 and 4 of the leading chain, at 0.75 and 1.
            float[] weights = Weights(rig, last);
            Assert.That(weights[3], Is.EqualTo(0.4f).Within(1e-5f));
            Assert.That(weights[4], Is.EqualTo(0.6f).Within(1e-5f));
        }

        [Test]
        public void SplitVerticesOfASeam_HaveEqualWeights()
        {
            SurfaceMesh split = Split(TestWings.Ellipse());
            WingRig rig = Bake(TestWings.Fan(), split);
            for (int a = 0; a < rig.VertexCount; a++)
            {
                for (int b = a + 1; b < rig.VertexCount; b++)
                {
                    if (split.positions[a] != split.positions[b])
                        continue;
                    Assert.That(rig.VertexJoints[a], Is.EqualTo(rig.VertexJoints[b]));
                    Assert.That(rig.VertexWeights[a], Is.EqualTo(rig.VertexWeights[b]));
                }
            }
        }

        [Test]
        public void TheMapFromJointsToVertices_IsTheWeightsThatAreNotZero()
        {
            WingRig rig = Bake();
            Assert.That(rig.JointVertexStarts.Length, Is.EqualTo(rig.JointCount + 1));
            Assert.That(rig.JointVertexStarts[rig.JointCount], Is.EqualTo(rig.JointVertices.Length));
            for (int joint = 0; joint < rig.JointCount; joint++)
            {
                int next = rig.JointVertexStarts[joint];
                for (int k = 0; k < rig.VertexCount; k++)
                {
                    if (Weights(rig, k)[joint] != 0f)
                        Assert.That(rig.JointVertices[next++], Is.EqualTo(k), $"joint {joint}");
                }

                Assert.That(next, Is.EqualTo(rig.JointVertexStarts[joint + 1]), $"joint {joint}");
            }
        }

        private static float[] Weights(WingRig rig, int vertex)
        {
            float[] weights = new float[rig.JointCount];
            for (int c = 0; c < 4; c++)
                weights[rig.VertexJoints[vertex][c]] += rig.VertexWeights[vertex][c];
            return weights;
        }

        private static float Change(float[] a, float[] b)
        {
            float change = 0f;
            for (int joint = 0; joint < a.Length; joint++)
                change += math.abs(a[joint] - b[joint]);
            return change;
        }

        private static Vector3 Rim(float t)
        {
            float angle = 0.5f * math.PI * t;
            return new Vector3(1.1f * math.cos(angle), 0f, -0.6f * math.sin(angle));
        }

        private static Func<float, Vector3> Chord(Random random)
        {
            var from = new Vector3((float)random.NextDouble(), 0f, 0.1f);
            var to = new Vector3(1.1f * (float)random.NextDouble(), 0f, -0.6f);
            return t => from + (to - from) * t;
        }

        // The usual wing, so that mesh and skeleton fit, and after it the points of the way as unused vertices.
        private static SurfaceMesh Line(Func<float, Vector3> way, int steps)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            int first = surface.positions.Length;
            Array.Resize(ref surface.positions, first + steps + 1);
            for (int k = 0; k <= steps; k++)
                surface.positions[first + k] = way((float)k / steps);
            surface.normals = null;
            return surface;
        }

        // Every triangle gets corners of its own.
        private static SurfaceMesh Split(SurfaceMesh surface)
        {
            var positions = new Vector3[surface.triangles.Length];
            int[] triangles = new int[surface.triangles.Length];
            for (int k = 0; k < triangles.Length; k++)
            {
                positions[k] = surface.positions[surface.triangles[k]];
                triangles[k] = k;
            }

            return new SurfaceMesh { positions = positions, triangles = triangles };
        }
    }
}
