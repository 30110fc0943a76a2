using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Places where a fit begins to doubt: just before and just beyond each of them.</summary>
    public sealed class FitThresholdTests
    {
        // The plate of the tests is 1 by 1/2; its farthest corners lie sqrt(5)/4 from its middle, so that its extent is this.
        private static readonly float s_Extent = 0.5f * Mathf.Sqrt(5f);

        [TestCase(0.098f, true)]
        [TestCase(0.102f, false)]
        public void AHinge_MayLieATenthOfTheExtentOffTheOutline_BesideOrAboveIt(float share, bool isUsed)
        {
            foreach (Vector3 off in new[] { new Vector3(-share * s_Extent, 0f, -0.25f), new Vector3(0f, share * s_Extent, -0.25f) })
            {
                SkeletonFitSettings hints = SkeletonFitSettings.Default;
                hints.hinge = off;
                SkeletonFit fit = SkeletonFitter.Fit(TestWings.Rectangle(), hints);

                Assert.That(fit.Skeleton.Hinge, isUsed ? Is.EqualTo(off) : Is.EqualTo(fit.Skeleton.GetJoint(0, 0)));
                Assert.That(fit.Warns(SkeletonFitWarningKind.HingeOffWing), Is.Not.EqualTo(isUsed));
                Assert.That(fit.Confidence / Told(), Is.EqualTo(isUsed ? 1f : 0.7f).Within(1e-4f));
            }
        }

        [TestCase(0.098f, 0.85f, "where the mesh's origin is")]
        [TestCase(0.102f, 0.75f, "the body is taken to be at the mesh's origin")]
        [TestCase(2.98f, 0.75f, "the body is taken to be at the mesh's origin")]
        [TestCase(3.02f, 0.6f, "at the narrower end")]
        public void TheMeshesOrigin_IsTakenForTheHingeThenForTheBody_ByItsDistance(float share, float confidence, string said)
        {
            SurfaceMesh plate = TestWings.Rectangle();
            for (int k = 0; k < plate.positions.Length; k++)
                plate.positions[k] += new Vector3(share * s_Extent, 0f, 0.25f);
            SkeletonFit fit = SkeletonFitter.Fit(plate, SkeletonFitSettings.Default);

            Assert.That(fit.Warnings[0].ToString(), Does.Contain(said));
            Assert.That(fit.Confidence / Told(), Is.EqualTo(confidence).Within(1e-3f));
        }

        [TestCase(0.21f, false)]
        [TestCase(0.19f, true)]
        public void ABodySide_TellsTheBase_WhereAFifthOfItLiesInThePlane(float share, bool isGuessed)
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.bodySide = 7f * new Vector3(-share, Mathf.Sqrt(1f - share * share), 0f);
            SkeletonFit fit = SkeletonFitter.Fit(TestWings.Rectangle(), hints);

            Assert.That(fit.Warns(SkeletonFitWarningKind.HingeGuessed), Is.EqualTo(isGuessed));
        }

        [TestCase(31f, 0f, false)]
        [TestCase(29f, 0f, true)]
        [TestCase(149f, 0f, false)]
        [TestCase(90f, 0.975f, false)]
        [TestCase(90f, 0.985f, true)]
        public void AForward_TellsTheEdges_ThirtyDegreesFromTheWing_WithAFifthInThePlane(float degrees, float up, bool isGuessed)
        {
            float flat = Mathf.Sqrt(1f - up * up), angle = Mathf.Deg2Rad * degrees;
            SkeletonFitSettings hints = Hinged();
            hints.forward = 5f * new Vector3(flat * Mathf.Cos(angle), up, flat * Mathf.Sin(angle));
            SkeletonFit fit = SkeletonFitter.Fit(TestWings.Rectangle(), hints);

            Assert.That(fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed), Is.EqualTo(isGuessed));
            if (!isGuessed)
            {
                Assert.That(Vector3.Dot(fit.Skeleton.SpanAxis, new Vector3(Mathf.Cos(angle), 0f, Mathf.Sin(angle))),
                    Is.EqualTo(0f).Within(1e-3f), "the span runs across it");
            }
        }

        [Test]
        public void AGuessedLeadingEdge_IsLeastCertainWhereBothBulgeAlike()
        {
            SkeletonFitSettings hints = Hinged();
            hints.hinge = Vector3.zero;
            hints.forward = null;
            float Confidence(float front, float rear)
            {
                SurfaceMesh lens = TestWings.Rectangle(40, 8, 1f, 1f);
                for (int k = 0; k < lens.positions.Length; k++)
                {
                    float x = lens.positions[k].x, bulge = x * (1f - x);
                    lens.positions[k].z = bulge * math.lerp(front, -rear, -lens.positions[k].z);
                }

                hints.forward = null;
                float guessed = SkeletonFitter.Fit(lens, hints).Confidence;
                hints.forward = Vector3.forward;
                return guessed / SkeletonFitter.Fit(lens, hints).Confidence;
            }

            Assert.That(Confidence(0.5f, 0.5f), Is.EqualTo(0.65f).Within(0.01f));
            Assert.That(Confidence(0.1f, 0.9f), Is.EqualTo(0.9f).Within(0.01f));
            Assert.That(Confidence(0.425f, 0.575f), Is.EqualTo(0.775f).Within(0.006f), "halfway, where the areas differ by 0.15");
        }

        [TestCase(0.9e-3, 0)]
        [TestCase(1.1e-3, 1)]
        public void AHole_CountsFromAThousandthOfTheWing(double share, int warnings)
        {
            // A square without a smaller one in its middle: h² / (4 − h²) of what is left.
            float h = (float)Math.Sqrt(4.0 * share / (1.0 + share)) / 2f;
            float3[] points = { new float3(-1, 0, -1), new float3(1, 0, -1), new float3(1, 0, 1), new float3(-1, 0, 1),
                new float3(-h, 0, -h), new float3(h, 0, -h), new float3(h, 0, h), new float3(-h, 0, h) };
            var triangles = new List<int3>();
            for (int k = 0; k < 4; k++)
            {
                int next = (k + 1) % 4;
                triangles.Add(new int3(k, 4 + next, next));
                triangles.Add(new int3(k, 4 + k, 4 + next));
            }

            FitNotes notes = Doubts(points, triangles);
            Assert.That(notes.Warnings.Count(warning => warning.Kind == SkeletonFitWarningKind.Holes), Is.EqualTo(warnings));
            Assert.That(notes.Confidence, Is.EqualTo(warnings == 0 ? 1.0 : 0.95).Within(1e-6));
            if (warnings > 0)
                Assert.That(notes.Warnings[0].ToString(), Does.Contain("a hole, the largest of 0.1 %"));
        }

        [TestCase(0.86, 1.0)]
        [TestCase(0.84, 0.84 / 0.85)]
        public void AWing_IsStronglyCurved_WhereLessThan85PercentOfItIsSeenFromAbove(double flat, double confidence)
        {
            // A roof of two sides whose slope has this cosine.
            float x = (float)flat, y = (float)Math.Sqrt(1.0 - flat * flat);
            float3[] points = { new float3(-x, 0, 0), new float3(-x, 0, 1), new float3(0, y, 1), new float3(0, y, 0), new float3(x, 0, 0),
                new float3(x, 0, 1) };
            FitNotes notes = Doubts(points, new List<int3> { new int3(0, 1, 2), new int3(0, 2, 3), new int3(3, 2, 5), new int3(3, 5, 4) });

            Assert.That(notes.Warned(SkeletonFitWarningKind.StronglyCurved), Is.EqualTo(confidence < 1.0));
            Assert.That(notes.Confidence, Is.EqualTo(confidence).Within(1e-4));
        }

        [TestCase(0.007, false)]
        [TestCase(0.008, true)]
        public void AFlapOverTheWing_IsAFold_WhereTheOutlineEnclosesOnePointFivePercentLess(double flap, bool isFold)
        {
            // A triangle on the edge of a square of 1 is folded back over it: the outline loses its area once, the triangles gain it.
            float z = (float)(2.0 * flap);
            float3[] points = { new float3(0, 0, 0), new float3(1, 0, 0), new float3(1, 0, 1), new float3(0, 0, 1),
                new float3(0.5f, 0.01f, z) };
            FitNotes notes = Doubts(points, new List<int3> { new int3(0, 2, 1), new int3(0, 3, 2), new int3(0, 1, 4) });

            Assert.That(notes.Warned(SkeletonFitWarningKind.FoldsOverItself), Is.EqualTo(isFold));
            Assert.That(notes.Confidence, Is.EqualTo(isFold ? (1.0 - flap) / (1.0 + flap) : 1.0).Within(1e-6));
        }

        [TestCase(0.019f, true)]
        [TestCase(0.021f, false)]
        public void APieceBesideTheWing_IsLeftOutUpToTwoPercentOfItsArea(float share, bool isLeftOut)
        {
            SurfaceMesh plate = TestWings.Rectangle();
            int count = plate.positions.Length;
            float side = Mathf.Sqrt(share);
            Vector3[] speck = new[] { new Vector3(2f, 0f, 0f), new Vector3(2f, 0f, side), new Vector3(2f + side, 0f, 0f) };
            var both = new SurfaceMesh
            {
                name = "Both",
                positions = plate.positions.Concat(speck).ToArray(),
                triangles = plate.triangles
                .Concat(new[] { count, count + 1, count + 2 }).ToArray()
            };
            if (!isLeftOut)
            {
                Assert.That(() => SkeletonFitter.Fit(both, Hinged()),
                    Throws.ArgumentException.With.Message.Contains("is not one wing but 2 pieces apart, the largest with 98 %"));
                return;
            }

            SkeletonFit fit = SkeletonFitter.Fit(both, Hinged());
            Assert.That(fit.Warns(SkeletonFitWarningKind.PiecesIgnored), Is.True);
            Assert.That(fit.Confidence / Told(), Is.EqualTo(0.95f).Within(1e-4f));
        }

        [TestCase(0.13f, false)]
        [TestCase(0.15f, true)]
        public void AFoldedSheet_IsTakenForAShell_WhereItsOutlineEnclosesLessThanThreeQuarters(float flap, bool isShell)
        {
            // The square of 1 with a triangle folded back over it: (1 − flap) / (1 + flap) is 3/4 at 1/7.
            Vector3[] points = new[] { new Vector3(0, 0, 0), new Vector3(1, 0, 0), new Vector3(1, 0, 1), new Vector3(0, 0, 1),
                new Vector3(0.5f, 0.01f, 2f * flap) };
            FitNotes notes = Read(points, new[] { 0, 2, 1, 0, 3, 2, 0, 1, 4 });

            Assert.That(notes.Warned(SkeletonFitWarningKind.ClosedShell), Is.EqualTo(isShell));
            Assert.That(notes.Warned(SkeletonFitWarningKind.FoldsOverItself), Is.Not.EqualTo(isShell));
        }

        [TestCase(0.27f, true)]
        [TestCase(0.29f, false)]
        public void AClosedShell_IsAWing_WhereMoreThan65PercentOfItFaceUpOrDown(float height, bool isWing)
        {
            // A square of 1 over one of 0.98, with walls around: 2 of 1.9604 + 3.96 · the walls' width.
            const float low = 0.49f;
            Vector3[] Ring(float half, float y) => new[] { new Vector3(-half, y, -half), new Vector3(half, y, -half),
                new Vector3(half, y, half), new Vector3(-half, y, half) };
            Vector3[] points = Ring(0.5f, height).Concat(Ring(low, 0f)).ToArray();
            var triangles = new List<int> { 0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7 };
            for (int k = 0; k < 4; k++)
            {
                int next = (k + 1) % 4;
                triangles.AddRange(new[] { k, next, 4 + next, k, 4 + next, 4 + k });
            }

            if (isWing)
                Assert.That(Read(points, triangles.ToArray()).Warned(SkeletonFitWarningKind.ClosedShell), Is.True);
            else
                Assert.That(() => Read(points, triangles.ToArray()), Throws.ArgumentException.With.Message.Contains("64 % of its area"));
        }

        [TestCase(0.08, 0.12, 1)]
        [TestCase(0.08, 0.09, 0)]
        [TestCase(0.13, 0.3, 1)]
        [TestCase(0.14, 0.3, 0)]
        public void AStripOnTheRearMargin_IsATail_AndASlotACleft_WhereItIsNarrowAndLong(double width, double length, int found)
        {
            // At least three and a half times as long a way round as it is wide, and at most a quarter of the mean chord, which is the area
            // of a wing of reach 1.
            foreach (double sign in new[] { 1.0, -1.0 })
            {
                double half = 0.5 * width, rear = sign > 0.0 ? -0.25 : -0.25 - width * length, deep = rear - sign * length;
                PlanPoint[] corners =
                {
                    new PlanPoint(0, 0), new PlanPoint(0, 0.25), new PlanPoint(1, 0.25), new PlanPoint(1, rear),
                    new PlanPoint(0.5 + half, rear), new PlanPoint(0.5 + half, deep),
                    new PlanPoint(0.5 - half, deep), new PlanPoint(0.5 - half, rear), new PlanPoint(0, rear),
                };
                var outline = new ClosedCurve(corners, 1600);
                var trimmed = new TrimmedOutline(outline, 0.25, outline.Length - 0.25);
                IReadOnlyList<OutlineStretch> narrow = sign > 0.0 ? trimmed.Tails : trimmed.Clefts,
                    other = sign > 0.0 ? trimmed.Clefts : trimmed.Tails;

                // A slot takes from the area what a tail adds; the rear of the slotted wing makes up for it but once.
                if (sign < 0.0 && width > 0.1)
                    continue;
                Assert.That((narrow.Count, other.Count), Is.EqualTo((found, 0)), $"sign {sign}");
                if (found == 0 || sign < 0.0)
                    continue;
                double middle = 0.5 * (narrow[0].from + narrow[0].to);
                Assert.That(trimmed.At(middle).z, Is.EqualTo(rear).Within(0.02), "straight across its root");
                Assert.That(trimmed.EndOf(narrow[0]).z, Is.EqualTo(deep).Within(0.01));
                Assert.That(trimmed.TryFindTail(middle, out _), Is.True);
                Assert.That(trimmed.TryFindTail(narrow[0].from - 0.01, out _), Is.False);
                trimmed.Restore(narrow[0]);
                Assert.That(trimmed.At(middle).z, Is.EqualTo(deep).Within(0.01));
            }
        }

        [Test]
        public void FiveChainsOfFiveJoints_TowardsPlusZ_AreTheDefault()
        {
            SkeletonFitSettings settings = SkeletonFitSettings.Default;

            Assert.That((settings.chains, settings.jointsPerChain, settings.forward), Is.EqualTo((5, 5, (Vector3?)Vector3.forward)));
            Assert.That((settings.hinge, settings.bodyPoint, settings.bodySide, settings.up),
                Is.EqualTo(((Vector3?)null, (Vector3?)null, (Vector3?)null, (Vector3?)null)));
        }

        private static FitNotes Doubts(float3[] points, List<int3> triangles)
        {
            var notes = new FitNotes();
            SheetDoubts.Warn(new WingSheet(points, triangles, WingPlane.Facing(new float3(0f, 1f, 0f)), 1e-5f), notes);
            return notes;
        }

        private static FitNotes Read(Vector3[] positions, int[] triangles)
        {
            var notes = new FitNotes();
            var surface = new SurfaceMesh { positions = positions, triangles = triangles };
            new SheetReader("Mesh", new UnitSurface(surface), Vector3.up, notes).Read();
            return notes;
        }

        private static SkeletonFitSettings Hinged()
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.hinge = new Vector3(0f, 0f, -0.25f);
            return hints;
        }

        // What is left of the confidence where the hinge is said: a plate's tip is not clear.
        private static float Told() => SkeletonFitter.Fit(TestWings.Rectangle(), Hinged()).Confidence;
    }
}
