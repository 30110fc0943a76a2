using System;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.Json.Nodes;
using Alate.Editor.Tests;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary><c>insect new</c> where the user says what would be guessed: hinges and leading edges, of pictures and of meshes.</summary>
    public sealed class InsectNewHintTests
    {
        private static readonly string[] s_Rest = ["--length", "50mm", "--mass", "1.6g", "--frequency", "25Hz"];

        private CommandRun m_Run;
        private string m_Wing;
        private WingPlace m_Place;

        [SetUp]
        public void Draw()
        {
            m_Run = new CommandRun();
            m_Wing = Path.Combine(m_Run.Folder, "wing.png");
            m_Place = DrawnWing.Scalloped().In(200);
            File.WriteAllBytes(m_Wing, PngOf.Picture(m_Place.Draw(DrawnKind.Silhouette)));
        }

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        // The hinge is the origin of the mesh, and texture coordinates say where in the picture that is.
        [Test]
        public void AHingeThatIsSaid_IsTaken_AtEitherEndOfTheWing()
        {
            foreach (float share in new[] { 0.02f, 0.97f })
            {
                UnityEngine.Vector2 place = m_Place.At(new UnityEngine.Vector2(share, 0f));
                New("--wing", m_Wing, "--hinge", FormattableString.Invariant($"{place.x},{place.y}"));

                Assert.That(Vector2.Distance(PictureOfOrigin("wing.obj"), new Vector2(place.x, place.y)), Is.LessThan(0.5f));
                Assert.That(m_Run.Output, Does.Not.Contain("hinge"));
            }
        }

        [Test]
        public void AutoAndNothing_AreTheSame_AndTheSecondPlaceIsThatOfTheHindWing()
        {
            UnityEngine.Vector2 tip = m_Place.At(new UnityEngine.Vector2(0.97f, 0f));
            New("--wing", m_Wing, m_Wing);
            Vector2 found = PictureOfOrigin("hind.obj");
            byte[] fore = File.ReadAllBytes(Path.Combine(m_Run.Out, "fore.json"));
            Assert.That(m_Run.Output, Does.Contain("--hinge says the place"));
            New("--wing", m_Wing, m_Wing, "--hinge", "auto", FormattableString.Invariant($"{tip.x},{tip.y}"));

            Assert.That(File.ReadAllBytes(Path.Combine(m_Run.Out, "fore.json")), Is.EqualTo(fore));
            Assert.That(Vector2.Distance(found, PictureOfOrigin("hind.obj")), Is.GreaterThan(0.5f * m_Place.Length));
        }

        [Test]
        public void TheLeadingEdge_IsTheSideThatIsSaid()
        {
            New("--wing", m_Wing, "--leading", "up");
            string up = File.ReadAllText(Path.Combine(m_Run.Out, "wing.json"));
            New("--wing", m_Wing, "--leading", "auto");
            Assert.That(File.ReadAllText(Path.Combine(m_Run.Out, "wing.json")), Is.EqualTo(up), "up by default");
            New("--wing", m_Wing, "--leading", "Down");
            Assert.That(File.ReadAllText(Path.Combine(m_Run.Out, "wing.json")), Is.Not.EqualTo(up));
        }

        [Test]
        public void TheHingeOfAMesh_IsInItsSpace()
        {
            New("--wing", m_Wing);
            string mesh = Path.Combine(m_Run.Folder, "own.obj");
            File.Copy(Path.Combine(m_Run.Out, "wing.obj"), mesh);
            File.WriteAllText(Path.Combine(m_Run.Folder, "wing.mtl"), "newmtl wing\n");
            New("--wing", mesh, "--hinge", "0.01,0,0.005");

            var skeleton = JsonNode.Parse(File.ReadAllText(Path.Combine(m_Run.Out, "wing.json")));
            Assert.That(skeleton["hinge"].AsArray().Select(number => (double)number),
                Is.EqualTo(new[] { 0.01, 0, 0.005 }).Within(1e-6));
        }

        [TestCase("--hinge of {0} takes X,Y, pixels from the picture's top left corner, or 'auto', not '12'.", "--hinge", "12")]
        [TestCase("or 'auto', not '1,2,3'.", "--hinge", "1,2,3")]
        [TestCase("or 'auto', not 'NaN,4'.", "--hinge", "NaN,4")]
        [TestCase("The hinge (900, 4) lies outside the picture, which is 200 × 200 pixels.", "--hinge", "900,4")]
        [TestCase("--hinge takes one for each wing: 1, not 2.", "--hinge", "1,2", "3,4")]
        [TestCase("--leading takes one for each wing: 1, not 2.", "--leading", "up", "up")]
        [TestCase("--leading of {0} takes up, down, left, right or auto, not 'north'.", "--leading", "north")]
        public void WhatIsWrong_IsOneLine_AndNothingIsWritten(string message, params string[] words)
        {
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", m_Wing, .. words, .. s_Rest]), Is.EqualTo(2));
            Assert.That(m_Run.Errors.Trim(), Does.Contain(string.Format(message, m_Wing)).And.Not.Contain("\n"));
            Assert.That(Directory.Exists(m_Run.Out), Is.False);
        }

        [TestCase("--leading is the side of a picture", "--leading", "up")]
        [TestCase("takes X,Y,Z in the space of the mesh or 'auto', not '1,2'.", "--hinge", "1,2")]
        public void WhatIsWrongForAMesh_IsOneLine(string message, params string[] words)
        {
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", "wing.obj", .. words, .. s_Rest]), Is.EqualTo(2));
            Assert.That(m_Run.Errors.Trim(), Does.Contain(message).And.Not.Contain("\n"));
        }

        private void New(params string[] words)
        {
            if (Directory.Exists(m_Run.Out))
                Directory.Delete(m_Run.Out, true);
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, .. words, .. s_Rest]), Is.Zero, m_Run.Errors);
        }

        // Pixels from the top left corner at which the mesh has its origin: texture coordinates are linear in the plane of the wing.
        private Vector2 PictureOfOrigin(string file)
        {
            using StreamReader text = File.OpenText(Path.Combine(m_Run.Out, file));
            Alate.Files.ObjMesh mesh = Alate.Files.ObjReader.Read(text);
            Vector2 Flat(int vertex) => new(mesh.Positions[vertex].x, mesh.Positions[vertex].z);
            Vector2 Uv(int vertex) => new(mesh.Uvs[vertex].x, mesh.Uvs[vertex].y);
            int far = Enumerable.Range(0, mesh.Positions.Length).MaxBy(k => Flat(k).Length());
            int other = Enumerable.Range(0, mesh.Positions.Length).MaxBy(k => Vector2.Distance(Flat(k), Flat(far)));
            Vector2 line = Flat(far) - Flat(other), seen = 200 * (Uv(far) - Uv(other));
            // The picture's y runs down; a similarity that may mirror is found from two points and the sign of a third.
            float scale = seen.Length() / line.Length();
            int third = Enumerable.Range(0, mesh.Positions.Length).MaxBy(k => Math.Abs(Cross(line, Flat(k) - Flat(other))));
            bool isMirrored = Cross(line, Flat(third) - Flat(other)) * Cross(seen, Uv(third) - Uv(other)) < 0;
            Vector2 from = -Flat(other);
            float along = Vector2.Dot(from, line) / line.Length(), across = Cross(line, from) / line.Length() * (isMirrored ? -1 : 1);
            Vector2 way = seen / seen.Length();
            Vector2 at = 200 * Uv(other) + scale * (along * way + across * new Vector2(-way.Y, way.X));
            return new Vector2(at.X, 200 - at.Y);
        }

        private static float Cross(Vector2 a, Vector2 b) => a.X * b.Y - a.Y * b.X;
    }
}
