using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Deformations that are known in closed form.</summary>
    public sealed class BeatMeasurementTests
    {
        private const float k_Degree = math.PI / 180f;

        private static readonly Func<float3, float, float3> s_Still = (place, phase) => place;

        private static readonly Func<float, quaternion> s_NoStroke = phase => quaternion.identity;

        [Test]
        public void RigidFlappingWing_HasNoDeformation()
        {
            WingDeformation beat = Measure(Sheet.Stroke, s_Still);

            Assert.That(beat.TwistRange, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(beat.CamberMin, Is.EqualTo(0f).Within(1e-5f));
            Assert.That(beat.CamberMax, Is.EqualTo(0f).Within(1e-5f));
            Assert.That(beat.TipBendRange, Is.EqualTo(0f).Within(1e-5f));
            Assert.That(beat.TipBendMax, Is.EqualTo(0f).Within(1e-5f));
            Assert.That(beat.Lag, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(beat.TipLag, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(beat.StretchMax, Is.EqualTo(0f).Within(1e-4f));
        }

        [Test]
        public void LinearTwist_IsItsShareBetweenTheTwoSections([Values(10f, 45f, 100f)] float degreesAtTip)
        {
            WingDeformation beat = Measure(
                Sheet.Stroke, (place, phase) => Sheet.Feathered(place, degreesAtTip * k_Degree * place.x * math.cos(phase)), 48);

            float between = BeatMeasurement.OuterSpan - BeatMeasurement.InnerSpan;
            Assert.That(beat.TwistRange / k_Degree, Is.EqualTo(2f * degreesAtTip * between).Within(0.5f).Percent);
            Assert.That(beat.CamberMax, Is.EqualTo(0f).Within(2e-3f), "a straight chord stays straight, but for the mesh's diagonals");
            Assert.That(beat.TipBendMax, Is.EqualTo(0f).Within(1e-4f), "the leading edge stays straight");
        }

        [Test]
        public void Twist_IsPositiveWhenTheOuterSectionIsNoseDown()
        {
            var sheet = new Sheet();

            float twist = sheet.Measurement.Twist(sheet.Deformed(place => Sheet.Feathered(place, 0.2f * place.x)));

            Assert.That(twist, Is.GreaterThan(0f), "feathering is positive with the leading edge down, the trailing edge up");
            Assert.That(Sheet.Feathered(new float3(0f, 0f, -1f), 0.2f).y, Is.GreaterThan(0f));
        }

        [Test]
        public void ParabolicCamber_IsItsHeightOverTheChord([Values(0.06f, -0.1f)] float height)
        {
            WingDeformation beat = Measure(
                s_NoStroke, (place, phase) => place + Parabola(place, height * math.max(math.cos(phase), 0f)), 4);

            float most = height * math.cos(0.15f * math.PI);
            Assert.That(beat.CamberMax, Is.EqualTo(math.max(most, 0f)).Within(1e-4f));
            Assert.That(beat.CamberMin, Is.EqualTo(math.min(most, 0f)).Within(1e-4f));
        }

        [Test]
        public void CamberBeyondAnotherBeat_IsThatOfTheDifference()
        {
            var sheet = new Sheet();
            List<BeatFrame> driven = sheet.Beat(Sheet.Stroke, (place, phase) => place + Parabola(place, 0.05f * math.sin(phase)));
            List<BeatFrame> loaded = sheet.Beat(
                Sheet.Stroke, (place, phase) => place + Parabola(place, 0.05f * math.sin(phase) - 0.03f * math.cos(phase)));

            Assert.That(sheet.Measurement.CamberBeyond(loaded, driven), Is.EqualTo(0.06f).Within(1f).Percent);
            Assert.That(sheet.Measurement.CamberBeyond(driven, driven), Is.Zero);
            Assert.Throws<ArgumentException>(() => sheet.Measurement.CamberBeyond(loaded, driven.GetRange(0, 3)));
        }

        [Test]
        public void Camber_IsTheSameHoweverTheWingIsTurned()
        {
            WingDeformation beat = Measure(Sheet.Stroke, (place, phase) => place + Parabola(place, 0.08f));

            Assert.That(beat.CamberMin, Is.EqualTo(0.08f).Within(1e-4f));
            Assert.That(beat.CamberMax, Is.EqualTo(0.08f).Within(1e-4f));
        }

        [Test]
        public void CircularArcOfTheSpan_BendsTheTipByHalfItsAngle([Values(10f, 40f)] float degrees)
        {
            WingDeformation beat = Measure(Sheet.Stroke, (place, phase) => Arc(place, degrees * k_Degree * math.cos(phase)), 48);

            float most = degrees * math.cos(2f * math.PI * 0.3f / 48f);
            Assert.That(beat.TipBendMax / k_Degree, Is.EqualTo(0.5f * most).Within(0.5f).Percent);
            Assert.That(beat.TipBendRange / k_Degree, Is.EqualTo(degrees).Within(1f).Percent);
            Assert.That(beat.TwistRange, Is.EqualTo(0f).Within(1e-4f), "chords stay parallel");
        }

        [Test]
        public void TrailingEdgeThatFollowsByAKnownPhase_HasThatLag([Values(10f, 30f, 75f)] float degrees)
        {
            // Each chordwise place heaves like the leading edge, later in proportion to its distance from it.
            WingDeformation beat = Measure(
                s_NoStroke,
                (place, phase) =>
                    place + new float3(0f, 0.2f * place.x * math.cos(phase + degrees * k_Degree * place.z / Sheet.Chord), 0f));

            // A root that does not turn has no phase of its own, so the whole delay counts.
            Assert.That(beat.Lag / k_Degree, Is.EqualTo(degrees).Within(0.2f));
        }

        [Test]
        public void LagOfAFlexibleWing_IsCountedFromThatOfTheRigidOne()
        {
            WingDeformation rigid = Measure(Sheet.Stroke, s_Still);
            WingDeformation late = Measure(
                Sheet.Stroke, (place, phase) => Sheet.Feathered(place, 0.3f * math.cos(phase - 0.5f * math.PI)));

            Assert.That(rigid.Lag, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(late.Lag, Is.Not.EqualTo(0f).Within(0.05f), "feathering beyond the root's moves the trailing edge's phase");
        }

        [Test]
        public void ATipThatFollowsItsRootByAKnownPhase_HasThatLag([Values(-20f, 10f, 60f)] float degrees)
        {
            const float k_Swing = 0.02f;
            var root = new Func<float, quaternion>(phase => quaternion.RotateZ(k_Swing * math.cos(phase)));
            // Turned back by the root, and on by the same swing later: as far out as the place lies.
            WingDeformation beat = Measure(root, (place, phase) => math.rotate(
                quaternion.RotateZ(k_Swing * (math.cos(phase - degrees * k_Degree * place.x) - math.cos(phase))), place));

            Assert.That(beat.TipLag / k_Degree, Is.EqualTo(degrees).Within(0.2f));
        }

        [Test]
        public void UniformStretch_IsTheStretchOfEveryEdge()
        {
            WingDeformation beat = Measure(s_NoStroke, (place, phase) => place * (1f + 0.03f * math.cos(phase)), 4);

            float most = 0.03f * math.cos(0.15f * math.PI);
            Assert.That(beat.StretchMax, Is.EqualTo(most).Within(1e-4f));
            Assert.That(beat.Stretch99, Is.EqualTo(most).Within(1e-4f));
        }

        [Test]
        public void OneTornEdgeOfMany_IsInTheLargestButNotInThePercentile()
        {
            var sheet = new Sheet();
            List<BeatFrame> beat = sheet.Beat(s_NoStroke, s_Still);
            beat[5].Positions[0] += new float3(-0.02f, 0f, 0f);

            WingDeformation measured = sheet.Measurement.Measure(beat);

            Assert.That(measured.StretchMax, Is.GreaterThan(0.3f));
            Assert.That(measured.Stretch99, Is.EqualTo(0f).Within(1e-4f));
        }

        [Test]
        public void FewerThanThreeFrames_AreNoBeat()
        {
            var sheet = new Sheet();

            Assert.Throws<ArgumentException>(() => sheet.Measurement.Measure(sheet.Beat(s_NoStroke, s_Still, 2)));
            Assert.DoesNotThrow(() => sheet.Measurement.Measure(sheet.Beat(s_NoStroke, s_Still, 3)));
        }

        [Test]
        public void WingThatBeginsBeyondTheInnerSection_IsTwistedFromItsOwnBase()
        {
            // The membrane of a stalked wing, or one whose base lies inside the body.
            var sheet = new Sheet();
            float3[] stalked = sheet.Deformed(place => new float3(0.3f + 0.7f * place.x, place.y, place.z));
            var measurement = new BeatMeasurement(stalked, sheet.triangles);

            float twist = measurement.Twist(Array.ConvertAll(stalked, place => Sheet.Feathered(place, 0.4f * place.x)));

            Assert.That(twist, Is.EqualTo(0.4f * (BeatMeasurement.OuterSpan - 0.3f)).Within(6f).Percent);
        }

        [Test]
        public void Measurement_DoesNotDependOnHowFineTheMeshIs()
        {
            Func<float3, float, float3> move = (place, phase) =>
                Arc(Sheet.Feathered(place, 0.4f * place.x * math.sin(phase)), 0.5f * math.cos(phase));
            var coarse = new Sheet(20, 4);
            var fine = new Sheet(80, 16);

            WingDeformation one = coarse.Measurement.Measure(coarse.Beat(Sheet.Stroke, move));
            WingDeformation other = fine.Measurement.Measure(fine.Beat(Sheet.Stroke, move));

            Assert.That(one.TwistRange, Is.EqualTo(other.TwistRange).Within(1f).Percent);
            Assert.That(one.TipBendRange, Is.EqualTo(other.TipBendRange).Within(1f).Percent);
            Assert.That(one.Lag, Is.EqualTo(other.Lag).Within(0.01f));
        }

        private static WingDeformation Measure(
            Func<float, quaternion> root, Func<float3, float, float3> move, int frames = 24)
        {
            var sheet = new Sheet();
            return sheet.Measurement.Measure(sheet.Beat(root, move, frames));
        }

        // Highest in the middle of the chord.
        private static float3 Parabola(float3 place, float heightOverChord)
        {
            float share = -place.z / Sheet.Chord;
            return new float3(0f, 4f * heightOverChord * Sheet.Chord * share * (1f - share), 0f);
        }

        // The span bent to an arc of the given angle, its length kept.
        private static float3 Arc(float3 place, float angle)
        {
            if (math.abs(angle) < 1e-4f)
                return place;
            float radius = 1f / angle - place.y;
            return new float3(radius * math.sin(angle * place.x), 1f / angle - radius * math.cos(angle * place.x), place.z);
        }
    }
}
