using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Meshes as they come: split, doubled, cracked, closed, with holes; and those that are no wing.</summary>
    public sealed class FitMeshTests
    {
        [Test]
        public void TrianglesWithVerticesOfTheirOwn_ChangeNothing()
        {
            SurfaceMesh wing = Wing();
            AssertAlike(wing, Of(wing.triangles.Select(index => wing.positions[index]), Enumerable.Range(0, wing.triangles.Length)));
        }

        [Test]
        public void ADoubleSidedWing_IsOneSheet()
        {
            SurfaceMesh wing = Wing();
            int count = wing.positions.Length;
            IEnumerable<int> back = wing.triangles.Reverse();

            AssertAlike(wing, Of(wing.positions, wing.triangles.Concat(back)));
            AssertAlike(wing, Of(wing.positions.Concat(wing.positions), wing.triangles.Concat(back.Select(index => index + count))));
        }

        [Test]
        public void TrianglesTurnedAtRandom_ChangeNothing()
        {
            SurfaceMesh wing = Wing(), turned = Wing();
            for (int k = 0; k < wing.triangles.Length; k += 3 * (1 + k % 7))
                (turned.triangles[k], turned.triangles[k + 1]) = (wing.triangles[k + 1], wing.triangles[k]);

            AssertAlike(wing, turned);
        }

        [Test]
        public void TJunctions_AreNoHoles()
        {
            // A coarse half of the wing beside a fine one.
            SurfaceMesh coarse = Part(2, 1, 0f, 0.5f), fine = Part(12, 8, 0.5f, 1f);
            int count = coarse.positions.Length;
            SurfaceMesh joined = Of(
                coarse.positions.Concat(fine.positions), coarse.triangles.Concat(fine.triangles.Select(k => k + count)));
            SkeletonFit fit = SkeletonFitter.Fit(joined, Hints());

            Assert.That(fit.Warnings, Is.Empty);
            Assert.That(fit.Holes, Is.Empty);
            AssertAlike(Part(12, 8, 0f, 1f), joined);
        }

        [Test]
        public void ACrackBetweenParts_IsClosed()
        {
            SurfaceMesh near = Part(6, 4, 0f, 0.5f), far = Part(6, 4, 0.5f, 1f);
            int count = near.positions.Length;
            IEnumerable<Vector3> apart = far.positions.Select(p => p + new Vector3(2e-4f, 0f, 0f));

            AssertAlike(Part(12, 4, 0f, 1f), Of(near.positions.Concat(apart), near.triangles.Concat(far.triangles.Select(k => k + count))));
        }

        [Test]
        public void AThinShell_IsFittedByItsUpperSide()
        {
            SurfaceMesh wing = Wing(), shell = Shell(wing, 0.01f);
            SkeletonFit fit = SkeletonFitter.Fit(shell, Hints());

            Assert.That(fit.Warns(SkeletonFitWarningKind.ClosedShell), Is.True);
            Assert.That(
                fit.Skeleton.Chains.SelectMany(chain => chain.joints).Select(joint => joint.y), Is.All.EqualTo(0.01f).Within(1e-5f));
            AssertAlike(wing, shell, 0.015f);
        }

        [Test]
        public void AHole_IsReported_AndChainsRunAsIfItWereFilled()
        {
            SurfaceMesh wing = Part(20, 10, 0f, 1f);
            SurfaceMesh torn = Of(wing.positions, Without(wing, p => (p - new Vector3(0.5f, 0f, -0.2f)).magnitude < 0.12f));
            SkeletonFit fit = SkeletonFitter.Fit(torn, Hints());

            Assert.That(fit.Warns(SkeletonFitWarningKind.Holes), Is.True);
            Assert.That(fit.Holes.Count, Is.EqualTo(1));
            Assert.That(fit.Skeleton.Validate(), Is.Empty);
            AssertOuterJointsAlike(SkeletonFitter.Fit(wing, Hints()).Skeleton, fit.Skeleton);
        }

        [Test]
        public void PiecesOnTheWing_HaveNoSay()
        {
            SurfaceMesh wing = Wing();
            int count = wing.positions.Length;
            Vector3[] vein = new[] { new Vector3(0.2f, 0.01f, 0f), new Vector3(0.8f, 0.01f, 0f), new Vector3(0.5f, 0.01f, 0.02f) };
            SurfaceMesh veined = Of(wing.positions.Concat(vein), wing.triangles.Concat(new[] { count, count + 1, count + 2 }));

            Assert.That(SkeletonFitter.Fit(veined, Hints()).Warns(SkeletonFitWarningKind.PiecesIgnored), Is.True);
            AssertAlike(wing, veined);
        }

        [Test]
        public void AStronglyCurvedWing_SaysSo_AndStillFits()
        {
            SkeletonFit fit = SkeletonFitter.Fit(new PolarWing { aspect = 0.9, camber = -3.0 }.Mesh(4), Hints());

            Assert.That(fit.Warns(SkeletonFitWarningKind.StronglyCurved), Is.True);
            Assert.That(fit.Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void ASlenderWingCurvedAlongItsSpan_IsStillSeenFromAbove()
        {
            SkeletonFit fit = SkeletonFitter.Fit(new PolarWing { aspect = 0.08, bend = 0.3 }.Mesh(4), Hints());

            Assert.That(fit.Skeleton.Validate(), Is.Empty);
            Assert.That(Mathf.Abs(fit.Skeleton.UpAxis.y), Is.GreaterThan(0.9f));
        }

        [Test]
        public void TwoWings_AreNamed()
        {
            SurfaceMesh wing = Wing();
            int count = wing.positions.Length;
            IEnumerable<Vector3> left = wing.positions.Select(p => new Vector3(-0.5f - p.x, p.y, p.z));

            Assert.That(
                Refusal(Of(wing.positions.Concat(left), wing.triangles.Concat(wing.triangles.Select(k => k + count)))),
                Is.EqualTo("Mesh 'Test' is not one wing but 2 pieces apart, the largest with 50 % of the area; fit each wing by itself."));
        }

        [Test]
        public void AClosedBody_IsNamed()
        {
            Assert.That(Refusal(Shell(Part(4, 4, 0f, 1f), 0.5f)), Does.Contain("has no outline").And.Contain("thin shell"));
        }

        [Test]
        public void ABandWithATwist_TakesNoSkeleton_AndIsToldWhatMayHelp()
        {
            var positions = new List<Vector3>();
            var triangles = new List<int>();
            for (int k = 0; k < 60; k++)
            {
                float angle = 2f * Mathf.PI * k / 60f;
                var outward = new Vector3(Mathf.Cos(angle), 0f, Mathf.Sin(angle));
                Vector3 across = 0.3f * (Mathf.Cos(0.5f * angle) * outward + Mathf.Sin(0.5f * angle) * Vector3.up);
                positions.Add(outward - across);
                positions.Add(outward + across);
                int a = 2 * k, c = k < 59 ? a + 2 : 1, d = k < 59 ? a + 3 : 0;
                triangles.AddRange(new[] { a, a + 1, c, a + 1, d, c });
            }

            Assert.That(
                Assert.Throws<ArgumentException>(() => SkeletonFitter.Fit(Of(positions, triangles), SkeletonFitSettings.Default)).Message,
                Does.StartWith("Mesh 'Test' could not be given a skeleton of 5 chains of 5 joints: Chain ").And.EndsWith("may help."));
        }

        [Test]
        public void ASingleTriangle_IsNamed()
        {
            Assert.That(
                Refusal(Of(new[] { Vector3.zero, Vector3.right, Vector3.forward }, new[] { 0, 2, 1 })),
                Is.EqualTo("Mesh 'Test' is a single triangle; a wing has at least two."));
        }

        [Test]
        public void BrokenMeshes_AreNamed()
        {
            SurfaceMesh wing = Wing();
            Assert.That(Refusal(Of(new Vector3[0], new int[0])), Is.EqualTo("Mesh 'Test' has no vertices."));
            Assert.That(Refusal(Of(wing.positions, new int[0])), Is.EqualTo("Mesh 'Test' has no triangles."));
            Assert.That(Refusal(Of(wing.positions, new[] { 0, 1, -1 })), Does.Contain("triangle 0"));
            Assert.That(Refusal(Of(wing.positions.Select(p => new Vector3(p.x, 0f, 0f)), wing.triangles)),
                Does.Contain("no triangle with an area"));
            Assert.That(Refusal(Of(wing.positions.Select(p => Vector3.one), wing.triangles)), Does.Contain("no triangle with an area"));
            wing.positions[7].y = float.NaN;
            Assert.That(Refusal(wing), Does.Contain("vertex 7 is not finite"));
            Assert.Throws<ArgumentNullException>(() => SkeletonFitter.Fit((Mesh)null, Hints()));
        }

        [Test]
        public void WrongSettings_AreNamed()
        {
            AssertWrong((ref SkeletonFitSettings s) => s.chains = 2, "3 to 16 chains");
            AssertWrong((ref SkeletonFitSettings s) => s.jointsPerChain = 17, "3 to 16 joints");
            AssertWrong(
                (ref SkeletonFitSettings s) => s.hinge = new Vector3(float.NaN, 2f, 3f),
                "hinge to fit a skeleton by is not finite: (NaN, 2, 3)");
            AssertWrong((ref SkeletonFitSettings s) => s.bodyPoint = new Vector3(0f, float.PositiveInfinity, 0f), "body's point");
            AssertWrong((ref SkeletonFitSettings s) => s.bodySide = Vector3.zero, "body's side");
            AssertWrong((ref SkeletonFitSettings s) => s.forward = Vector3.zero, "forward direction");
            AssertWrong((ref SkeletonFitSettings s) => s.up = Vector3.zero, "up direction");
        }

        private delegate void Change(ref SkeletonFitSettings settings);

        private static void AssertWrong(Change change, string said)
        {
            SkeletonFitSettings settings = Hints();
            change(ref settings);
            string message = Assert.Catch<ArgumentException>(() => SkeletonFitter.Fit(Wing(), settings)).Message;
            Assert.That(message, Does.Contain(said));
        }

        private static string Refusal(SurfaceMesh surface)
        {
            string message = Assert.Throws<ArgumentException>(() => SkeletonFitter.Fit(surface, Hints())).Message;
            Assert.That(message, Does.Not.Contain("\n"));
            return message;
        }

        private static SurfaceMesh Wing() => new PolarWing { aspect = 0.5, tail = -0.2 }.Mesh(3);

        // The part of a rounded wing between two shares of its span.
        private static SurfaceMesh Part(int columns, int rows, float from, float to)
        {
            SurfaceMesh wing = TestWings.Rectangle(columns, rows);
            for (int k = 0; k < wing.positions.Length; k++)
            {
                float x = from + (to - from) * wing.positions[k].x, chord = x <= 0.5f ? 1f : 1.5f - x;
                wing.positions[k] = new Vector3(x, 0f, wing.positions[k].z * chord);
            }

            return Of(wing.positions, wing.triangles);
        }

        // Two sheets at ± half the thickness, with a wall around.
        private static SurfaceMesh Shell(SurfaceMesh sheet, float half)
        {
            int count = sheet.positions.Length;
            var triangles = new List<int>(sheet.triangles);
            var edges = new HashSet<(int, int)>();
            for (int k = 0; k < sheet.triangles.Length; k += 3)
            {
                int a = sheet.triangles[k], b = sheet.triangles[k + 1], c = sheet.triangles[k + 2];
                triangles.AddRange(new[] { a + count, c + count, b + count });
                edges.UnionWith(new[] { (a, b), (b, c), (c, a) });
            }

            foreach ((int a, int b) in edges.Where(edge => !edges.Contains((edge.Item2, edge.Item1))))
                triangles.AddRange(new[] { b, a, a + count, b, a + count, b + count });
            IEnumerable<Vector3> upper = sheet.positions.Select(p => p + half * Vector3.up);
            return Of(upper.Concat(sheet.positions.Select(p => p - half * Vector3.up)), triangles);
        }

        private static IEnumerable<int> Without(SurfaceMesh wing, Func<Vector3, bool> isGone)
        {
            for (int k = 0; k < wing.triangles.Length; k += 3)
            {
                int[] corners = { wing.triangles[k], wing.triangles[k + 1], wing.triangles[k + 2] };
                Vector3 middle = (wing.positions[corners[0]] + wing.positions[corners[1]] + wing.positions[corners[2]]) / 3f;
                foreach (int corner in isGone(middle) ? new int[0] : corners)
                    yield return corner;
            }
        }

        private static SurfaceMesh Of(IEnumerable<Vector3> positions, IEnumerable<int> triangles) =>
            new SurfaceMesh { name = "Test", positions = positions.ToArray(), triangles = triangles.ToArray() };

        private static SkeletonFitSettings Hints()
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.bodySide = Vector3.left;
            return hints;
        }

        private static void AssertAlike(SurfaceMesh one, SurfaceMesh other, float within = 0.003f)
        {
            WingSkeleton a = SkeletonFitter.Fit(one, Hints()).Skeleton, b = SkeletonFitter.Fit(other, Hints()).Skeleton;
            for (int i = 0; i < a.ChainCount; i++)
            {
                for (int j = 0; j < a.JointsPerChain; j++)
                    Assert.That(Vector3.Distance(a.GetJoint(i, j), b.GetJoint(i, j)), Is.LessThan(within), $"chain {i}, joint {j}");
            }
        }

        private static void AssertOuterJointsAlike(WingSkeleton one, WingSkeleton other)
        {
            for (int i = 0; i < one.ChainCount; i++)
            {
                Assert.That(Vector3.Distance(one.GetJoint(i, 0), other.GetJoint(i, 0)), Is.LessThan(0.003f));
                Assert.That(Vector3.Distance(one.GetJoint(i, 4), other.GetJoint(i, 4)), Is.LessThan(0.003f));
            }
        }
    }
}
