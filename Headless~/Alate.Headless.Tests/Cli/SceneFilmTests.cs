using System.IO;
using System.Linq;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>The command <c>film --scene</c>: samples of the package, played and painted.</summary>
    public sealed class SceneFilmTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void AFilmOfAScene_HasNumberedFrames_ThatMove()
        {
            PngFile[] frames = Film("monarch", "--seconds", "0.5", "--rate", "8", "--turn", "20");

            Assert.That(frames, Has.Length.EqualTo(4));
            Assert.That(frames.Select(frame => (frame.Width, frame.Height)), Is.All.EqualTo((160, 90)));
            for (int k = 1; k < frames.Length; k++)
                Assert.That(Difference(frames[k - 1], frames[k]), Is.GreaterThan(0.1), $"frame {k} is as the one before");
            var film = new ApngPlayer(File.ReadAllBytes(Path.Combine(m_Run.Out, "film.png")));
            Assert.That((film.Width, film.Height, film.Frames.Count), Is.EqualTo((160, 90, 4)));
            Assert.That(m_Run.Output, Does.Contain("0001.png … 0004.png"));
        }

        // Every sample shows insects in the middle of its picture, over the colour behind them.
        [Test]
        [Explicit]
        [Category("Long")]
        public void EverySample_ShowsMoreThanItsBackground([ValueSource(nameof(Names))] string scene)
        {
            PngFile frame = Film(scene, "--after", "2", "--seconds", "0.1", "--rate", "10").Single();

            int colours = frame.Pixels.Select(pixel => (pixel.r >> 4, pixel.g >> 4, pixel.b >> 4)).Distinct().Count();
            Assert.That(colours, Is.GreaterThan(12));
            Assert.That(frame.Pixels.Count(pixel => !pixel.Equals(frame.Pixels[0])), Is.GreaterThan(frame.Pixels.Length / 50));
        }

        [TestCase("monarch", Explicit = true, Category = "Long,Faults")]
        [TestCase("garden", "--set", "Butterflies=2", Explicit = true, Category = "Long")]
        public void TheSameScene_IsTheSameFilm(string scene, params string[] settings)
        {
            byte[] first = Animation(), again = Animation();

            Assert.That(again, Is.EqualTo(first));

            byte[] Animation()
            {
                Film(scene, ["--seconds", "0.3", "--rate", "10", .. settings]);
                return File.ReadAllBytes(Path.Combine(m_Run.Out, "film.png"));
            }
        }

        // The shader's constants are not the painter's: dusk is dark, and its slider is moved by the name of its label.
        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void ASliderOfThePanel_IsMoved()
        {
            PngFile[] day = Film("garden", "--seconds", "0.1", "--rate", "10", "--set", "Dusk=0"),
                night = Film("garden", "--seconds", "0.1", "--rate", "10", "--set", "dusk=1");

            Assert.That(Light(night[0]), Is.LessThan(0.4 * Light(day[0])));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void MomentsThatBlur_AreTheMeanOfTheirLight()
        {
            PngFile[] sharp = Film("monarch", "--seconds", "0.5", "--rate", "2"),
                blurred = Film("monarch", "--seconds", "0.5", "--rate", "2", "--exposures", "4");

            Assert.That(Difference(sharp[0], blurred[0]), Is.GreaterThan(0.1));
            Assert.That(Light(blurred[0]), Is.EqualTo(Light(sharp[0])).Within(3).Percent);
        }

        [TestCase("150,20,1.6", "150,20,0.8", 3.0, Explicit = true, Category = "Long,Faults")]
        public void TheCamera_ComesNearer(string far, string near, double factor)
        {
            int Seen(string look)
            {
                PngFile frame = Film("monarch", "--seconds", "0.1", "--rate", "10", "--look", look).Single();
                return frame.Pixels.Count(pixel => pixel.r > 2 * pixel.b);
            }

            Assert.That(Seen(near), Is.InRange(factor * Seen(far), 3 * factor * Seen(far)));
        }

        [TestCase("garden, insects", "film", "--scene", "desert")]
        [TestCase("its own insects", "film", "monarch", "--scene", "garden")]
        [TestCase("--variant", "film", "--scene", "garden", "--variant", "flight")]
        [TestCase("--beats", "film", "--scene", "garden", "--beats", "2")]
        [TestCase("--transparent", "film", "--scene", "garden", "--transparent")]
        [TestCase("--seconds goes with --scene", "film", "monarch", "--seconds", "2")]
        [TestCase("--set goes with --scene", "film", "monarch", "--set", "Dusk=1")]
        [TestCase("--seconds must lie between 0.1 and 120", "film", "--scene", "garden", "--seconds", "0")]
        [TestCase("--after must lie between 0 and 120", "film", "--scene", "garden", "--after", "-1")]
        [TestCase("--exposures must lie between 1 and 16", "film", "--scene", "garden", "--exposures", "17")]
        [TestCase("--look takes", "film", "--scene", "garden", "--look", "1,2")]
        [TestCase("--look takes", "film", "--scene", "garden", "--look", "0,90,1")]
        [TestCase("--look takes", "film", "--scene", "garden", "--look", "0,0,NaN")]
        [TestCase("'Moon'. It has: Butterflies=VALUE, Wind=VALUE, Aid=VALUE, Dusk=VALUE, Shy=VALUE, Watch=VALUE", "film", "--scene",
            "garden", "--set", "Moon=1")]
        [TestCase("'Dusk' must lie between 0 and 1; it is 2", "film", "--scene", "garden", "--set", "Dusk=2")]
        [TestCase("'Dusk' takes a finite number, not 'late'", "film", "--scene", "garden", "--set", "Dusk=late")]
        [TestCase("nothing named 'Dance'", "film", "--scene", "garden", "--set", "Dance")]
        [TestCase("fewer --seconds", "film", "--scene", "garden", "--seconds", "120", "--rate", "60", "--width", "1920")]
        [TestCase("or --scene NAME", "film")]
        public void WhatItDoesNotKnow_IsOneLine(string said, params string[] words)
        {
            int code = m_Run.Run([.. words, "--out", m_Run.Out]);

            Assert.That(code, Is.EqualTo(2), m_Run.Output);
            Assert.That(m_Run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1), m_Run.Errors);
            Assert.That(m_Run.Errors, Does.Contain(said));
            Assert.That(Directory.Exists(m_Run.Out), Is.False);
            Assert.That(Application.isPlaying, Is.False, "the scene plays on");
        }

        // A vertex of a baked insect is where the bake has it at the frame of its row.
        [Test]
        public void ABakedInsect_IsShown_AsTheShaderHasIt()
        {
            var map = new Texture2D(2, 8, TextureFormat.RGBAFloat, false);
            for (int y = 0; y < 8; y++)
            {
                for (int x = 0; x < 2; x++)
                    map.SetPixel(x, y, new Color(10f * x + y, y < 4 ? 1f : 0f, y < 4 ? 0f : 1f));
            }

            var shape = new MeshShape(
                [default, default], [default, default], [], null, [new float2(0.25f, 0.5f / 8), new float2(0.75f, 0.5f / 8)], null,
                null);
            MeshShape shown = new BakedLoops(map).Shape(shape, new float4(1f, 2f, 0.25f, 0f), default),
                blended = new BakedLoops(map).Shape(shape, new float4(1f, 2f, 0.25f, 0.5f), new float4(3f, 3f, 0f, 0f));

            Assert.That(shown.Places, Is.EqualTo(new[] { new float3(1.25f, 1f, 0f), new float3(11.25f, 1f, 0f) }));
            Assert.That(blended.Places[0].x, Is.EqualTo(0.5f * (1.25f + 3f)).Within(1e-5f));
            Assert.That(shown.Normals[0], Is.EqualTo(math.normalize(new float3(5.25f, 0f, 1f))));
            Object.DestroyImmediate(map);
        }

        // A mesh that scripts may not read is read all the same, and stays so.
        [Test]
        public void AShape_IsReadAndPlaced_WhereItsMeshIsNotReadable()
        {
            var mesh = new Mesh
            {
                vertices = [Vector3.zero, Vector3.right, Vector3.forward],
                normals = [Vector3.up, Vector3.up, Vector3.up],
                triangles = [0, 2, 1],
            };
            mesh.UploadMeshData(true);
            SceneSurface placed = MeshShape.Of(mesh, 0).Placed(
                float4x4.TRS(new float3(1f, 2f, 3f), quaternion.RotateZ(0.5f * math.PI), new float3(2f, 1f, 1f)), null);

            Assert.That(mesh.isReadable, Is.False);
            Assert.That(math.distance(placed.Places[1], new float3(1f, 4f, 3f)), Is.LessThan(1e-5f));
            Assert.That(math.distance(placed.Normals[0], new float3(-1f, 0f, 0f)), Is.LessThan(1e-5f));
            Assert.That((placed.Coordinates, placed.Colours), Is.EqualTo(((float2[])null, (float4[])null)));
            Object.DestroyImmediate(mesh);
        }

        private static string[] Names => [.. SampleScene.All.Select(scene => scene.Name)];

        private PngFile[] Film(string scene, params string[] options)
        {
            string frames = Path.Combine(m_Run.Out, "frames");
            if (Directory.Exists(frames))
                Directory.Delete(frames, true);
            Assert.That(m_Run.Run(["film", "--scene", scene, "--width", "160", "--out", m_Run.Out, .. options]), Is.Zero, m_Run.Errors);
            return [.. Directory.GetFiles(frames).Order().Select(file => PngFile.Read(File.ReadAllBytes(file)))];
        }

        private static double Difference(PngFile a, PngFile b) =>
            a.Pixels.Zip(b.Pixels, (one, other) => (double)Mathf.Abs(one.r - other.r) + Mathf.Abs(one.g - other.g)).Average();

        private static double Light(PngFile picture) => picture.Pixels.Average(pixel => pixel.r + pixel.g + pixel.b);
    }
}
