using System;
using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Crowds
{
    /// <summary>Bakes with fewer triangles.</summary>
    public sealed class SmallerBakeTests
    {
        [Test]
        public void EachVertexThatIsKept_KeepsAllThatWasBakedOfIt()
        {
            InsectBake whole = PlainBake.Make(6, 1), smaller = SmallerBake.Of(whole, 70, out _);
            int[] kept = Kept(whole, smaller);

            Assert.That(smaller.Surface.TriangleCount, Is.InRange(50, 70));
            for (int vertex = 0; vertex < kept.Length; vertex++)
            {
                Assert.That(smaller.Surface.Uvs[vertex], Is.EqualTo(whole.Surface.Uvs[kept[vertex]]));
                Assert.That(smaller.Surface.Normals[vertex], Is.EqualTo(whole.Surface.Normals[kept[vertex]]));
                Assert.That(smaller.Surface.Colours[vertex], Is.EqualTo(whole.Surface.Colours[kept[vertex]]));
                for (int clip = 0; clip < 2; clip++)
                {
                    for (int frame = 0; frame < whole.Clips[clip].Frames.Count; frame++)
                    {
                        BakedFrame from = whole.Clips[clip].Frames[frame], to = smaller.Clips[clip].Frames[frame];
                        Assert.That(to.Positions[vertex], Is.EqualTo(from.Positions[kept[vertex]]));
                        Assert.That(to.Normals[vertex], Is.EqualTo(from.Normals[kept[vertex]]));
                        Assert.That(to.Joints, Is.EqualTo(from.Joints));
                    }
                }
            }
        }

        [Test]
        public void Triangles_AreOfTheirParts_AndFaceTheSameWay()
        {
            InsectBake whole = PlainBake.Make(1), smaller = SmallerBake.Of(whole, 70, out _);
            int[] kept = Kept(whole, smaller);

            Assert.That(
                smaller.Surface.Parts.Select(part => (part.Name, part.HasColours)), Is.EqualTo(new[] { ("wings", true), ("body", false) }));
            foreach ((BakedPart from, BakedPart to) in whole.Surface.Parts.Zip(smaller.Surface.Parts, (from, to) => (from, to)))
            {
                Assert.That(to.Triangles.Select(corner => kept[corner]).Distinct(), Is.SubsetOf(from.Triangles));
                for (int k = 0; k < to.Triangles.Length; k += 3)
                {
                    float3 a = smaller.Surface.Positions[to.Triangles[k]], b = smaller.Surface.Positions[to.Triangles[k + 1]],
                        c = smaller.Surface.Positions[to.Triangles[k + 2]];
                    Assert.That(math.cross(b - a, c - a).y, Is.GreaterThan(0f));
                }
            }
        }

        [Test]
        public void Wings_KeepTheirVerticesJointsAndWeights()
        {
            InsectBake whole = PlainBake.Make(1), smaller = SmallerBake.Of(whole, 70, out _);
            int[] kept = Kept(whole, smaller);
            for (int w = 0; w < 2; w++)
            {
                BakedWing from = whole.Wings[w], to = smaller.Wings[w];
                Assert.That(
                    (to.Name, to.Side, to.Length, to.FirstJoint, to.JointsPerChain, to.RestJoints),
                    Is.EqualTo((from.Name, from.Side, from.Length, from.FirstJoint, from.JointsPerChain, from.RestJoints)));
                Assert.That(to.Vertices.Select(vertex => kept[vertex]), Is.EqualTo(from.Vertices.Where(kept.Contains)));
                for (int k = 0; k < to.Vertices.Length; k++)
                {
                    int place = Array.IndexOf(from.Vertices, kept[to.Vertices[k]]);
                    Assert.That(to.VertexJoints[k], Is.EqualTo(from.VertexJoints[place]));
                    Assert.That(to.VertexWeights[k], Is.EqualTo(from.VertexWeights[place]));
                }
            }

            Assert.That((smaller.Name, smaller.MetresPerUnit, smaller.WingLength, smaller.JointCount),
                Is.EqualTo((whole.Name, whole.MetresPerUnit, whole.WingLength, whole.JointCount)));
        }

        [Test]
        public void AnAbdomen_KeepsItsJoint_AndTheVerticesThatAreLeft()
        {
            InsectBake whole = PlainBake.Make(1), smaller = SmallerBake.Of(whole, 70, out _);
            int[] kept = Kept(whole, smaller);
            BakedAbdomen from = whole.Abdomens[0], to = smaller.Abdomens[0];

            Assert.That(smaller.Abdomens, Has.Count.EqualTo(1));
            Assert.That((to.Name, to.Joint, to.Hinge), Is.EqualTo((from.Name, from.Joint, from.Hinge)));
            Assert.That(
                Enumerable.Range(to.FirstVertex, to.VertexCount).Select(vertex => kept[vertex]),
                Is.EqualTo(kept.Where(vertex => vertex >= from.FirstVertex && vertex < from.FirstVertex + from.VertexCount)));
            Assert.That(to.VertexCount, Is.GreaterThan(2));
        }

        [Test]
        public void Clips_KeepHowTheyWereFlown()
        {
            InsectBake whole = PlainBake.Make(2, 3), smaller = SmallerBake.Of(whole, 70, out _);
            for (int k = 0; k < 2; k++)
            {
                BakedClip from = whole.Clips[k], to = smaller.Clips[k];
                Assert.That(to.Motion, Is.SameAs(from.Motion));
                Assert.That(
                    (to.Frequency, to.Velocity, to.AngularVelocity), Is.EqualTo((from.Frequency, from.Velocity, from.AngularVelocity)));
                Assert.That((to.Attitude, to.RightBeat, to.LeftBeat), Is.EqualTo((from.Attitude, from.RightBeat, from.LeftBeat)));
                Assert.That(to.Error, Is.EqualTo(from.Error));
            }
        }

        [Test]
        public void FewerTrianglesThanTheLeast_AreRefused()
        {
            InsectBake whole = PlainBake.Make(1);

            Assert.That(() => SmallerBake.Of(whole, 49, out _),
                Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("50 triangles or more"));
            Assert.That(SmallerBake.Of(whole, 50, out _).Surface.TriangleCount, Is.LessThanOrEqualTo(50));
            Assert.That(() => SmallerBake.Of(null, 50, out _), Throws.ArgumentNullException);
        }

        // No two vertices lie in one place.
        private static int[] Kept(InsectBake whole, InsectBake smaller) =>
            Array.ConvertAll(smaller.Surface.Positions, position => Array.IndexOf(whole.Surface.Positions, position));
    }
}
