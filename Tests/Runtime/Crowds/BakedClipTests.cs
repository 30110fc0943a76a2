using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Loops between their frames, what is said of a bake as a whole, and normals of scaled surfaces.</summary>
    public sealed class BakedClipTests
    {
        [TestCase(0.4f, 2, 2, 0f)]
        [TestCase(0.45f, 2, 3, 0.25f)]
        [TestCase(0.95f, 4, 0, 0.75f)]
        [TestCase(3.45f, 2, 3, 0.25f)]
        [TestCase(-0.05f, 4, 0, 0.75f)]
        [TestCase(-2f, 0, 1, 0f)]
        public void BetweenTwoFrames_BothAreBlended_AndPhasesRepeat(float phase, int before, int after, float share)
        {
            InsectBake bake = PlainBake.Make(5);
            BakedClip clip = bake.Clips[0];
            var positions = new float3[bake.Surface.VertexCount];
            var normals = new float3[positions.Length];
            clip.Evaluate(phase, positions, normals);
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                float3 place = (1f - share) * clip.Frames[before].Positions[vertex] + share * clip.Frames[after].Positions[vertex];
                float3 normal = (1f - share) * clip.Frames[before].Normals[vertex] + share * clip.Frames[after].Normals[vertex];
                Assert.That(math.distance(positions[vertex], place), Is.LessThan(2e-6f));
                Assert.That(math.distance(normals[vertex], math.normalize(normal)), Is.LessThan(2e-6f));
            }
        }

        [Test]
        public void Bounds_HoldAllFramesOfAllClips_AndNothingMore()
        {
            InsectBake bake = PlainBake.Make(4, 3);
            bake.Clips[0].Frames[2].Positions[7] = new float3(-9f, 0f, 0f);
            bake.Clips[1].Frames[2].Positions[0] = new float3(0f, 8f, -7f);
            bake.Clips[1].Frames[0].Positions[3] = new float3(6f, -5f, 4f);

            Assert.That(bake.Bounds.min, Is.EqualTo(new Vector3(-9f, -5f, -7f)));
            Assert.That(bake.Bounds.max, Is.EqualTo(new Vector3(6f, 8f, 4f)));
            Assert.That(bake.FrameCount, Is.EqualTo(7));
            Assert.That(bake.Surface.TriangleCount, Is.EqualTo(130));
        }

        [Test]
        public void Normals_StandOnTheTurnedSurface_OnTheSideTheyStoodOn([Values] bool mirrored)
        {
            var random = new Random(8u);
            for (int k = 0; k < 50; k++)
            {
                var scale = (Vector3)random.NextFloat3(0.3f, 3f);
                scale.x *= mirrored ? -1f : 1f;
                Matrix4x4 matrix = Matrix4x4.TRS(Vector3.one, (quaternion)random.NextQuaternionRotation(), scale)
                    * Matrix4x4.Rotate((quaternion)random.NextQuaternionRotation());
                float3 normal = random.NextFloat3Direction(), along = math.normalize(math.cross(normal, random.NextFloat3Direction())),
                    across = math.cross(normal, along);
                float3 turned = new NormalTransform(matrix).Apply(normal);

                Assert.That(math.length(turned), Is.EqualTo(1f).Within(1e-5f));
                Assert.That(math.dot(turned, matrix.MultiplyVector(along)), Is.EqualTo(0f).Within(1e-5f));
                Assert.That(math.dot(turned, matrix.MultiplyVector(across)), Is.EqualTo(0f).Within(1e-5f));
                Assert.That(math.dot(turned, matrix.MultiplyVector(normal)), Is.GreaterThan(0f));
            }

            Assert.That(new NormalTransform(Matrix4x4.identity).Apply(0f), Is.EqualTo(new float3(0f, 1f, 0f)), "up where there is none");
        }

        [TestCase(10, 1, 4)]
        [TestCase(64, 4, 16)]
        [TestCase(65, 4, 32)]
        [TestCase(100, 100, 128)]
        public void ATexture_IsTheNarrowestThatIsNotHigherThanWide(int vertices, int frames, int width)
        {
            var layout = BakeLayout.Fit(vertices, frames, 4096, false);

            Assert.That(layout.Width, Is.EqualTo(width));
            Assert.That(layout.Height, Is.EqualTo(frames * ((vertices + width - 1) / width)).And.LessThanOrEqualTo(width));
            Assert.That(
                frames * ((vertices + width / 2 - 1) / (width / 2)), Is.GreaterThan(width / 2), "half as wide would be higher than wide");
        }

        [Test]
        public void ATexture_MayBeAsHighAsIsAllowed_AndNoHigher()
        {
            // Two blocks of 64 columns.
            Assert.That(BakeLayout.Fit(128, 32, 64, false).Height, Is.EqualTo(64));
            Assert.That(BakeLayout.Fit(64, 32, 64, true).Height, Is.EqualTo(64));
            Assert.That(() => BakeLayout.Fit(128, 33, 64, false), Throws.TypeOf<BakeException>().With.Message.Contains("64 x 66 pixels"));
            Assert.That(() => BakeLayout.Fit(129, 32, 64, false), Throws.TypeOf<BakeException>().With.Message.Contains("64 x 96 pixels"));
            Assert.That(BakeLayout.Fit(64, 32, 64, true).NormalRows, Is.EqualTo(32));
        }

        [Test]
        public void Loops_HaveFourTo240Frames()
        {
            Assert.That(new BakeSettings(4).Frames, Is.EqualTo(4));
            Assert.That(new BakeSettings(240).Frames, Is.EqualTo(240));
            Assert.That(() => new BakeSettings(3), Throws.TypeOf<System.ArgumentOutOfRangeException>().With.Message.Contains("4 to 240"));
            Assert.That(() => new BakeSettings(241), Throws.TypeOf<System.ArgumentOutOfRangeException>());
        }
    }
}
