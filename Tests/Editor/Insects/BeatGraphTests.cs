using System;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Lines of the graphs, and the mean they name.</summary>
    public sealed class BeatGraphTests
    {
        private static readonly Rect s_Area = new Rect(10f, 20f, 200f, 50f);

        [Test]
        public void Scale_HoldsAllValues_AndZero()
        {
            var scale = new GraphScale();
            scale.Fit(20f, 60f, 1f);

            Assert.That(scale.Place(0f), Is.EqualTo(0f));
            Assert.That(scale.Place(60f), Is.EqualTo(1f));
        }

        [Test]
        public void Scale_WidensAtOnce_AndNarrowsSlowly()
        {
            var scale = new GraphScale();
            scale.Fit(-1f, 1f, 0.1f);
            scale.Fit(-4f, 8f, 0.1f);
            Assert.That(new[] { scale.Low, scale.High }, Is.EqualTo(new[] { -4f, 8f }));

            scale.Fit(-1f, 1f, 0.1f);
            Assert.That(scale.High, Is.InRange(7f, 8f));
            for (int look = 0; look < 1000; look++)
                scale.Fit(-1f, 1f, 0.1f);
            Assert.That(scale.High, Is.EqualTo(1f).Within(0.01f));
            Assert.That(scale.Low, Is.EqualTo(-1f).Within(0.01f));
        }

        [Test]
        public void Scale_NarrowsByAFiftiethOfTheWayEachTime_AtBothEnds()
        {
            var scale = new GraphScale();
            scale.Fit(-5f, 9f, 0.1f);
            for (int look = 0; look < 34; look++)
                scale.Fit(-1f, 1f, 0.1f);

            // (49 / 50)³⁴ is half, but for three thousandths.
            Assert.That(new[] { scale.Low, scale.High }, Is.EqualTo(new[] { -3f, 5f }).Within(0.05f));
            scale.Fit(3f, 4f, 0.1f);
            Assert.That(scale.Place(0f), Is.GreaterThan(0f), "nothing is cut off");
        }

        [Test]
        public void Scale_IsNeverEmpty()
        {
            var scale = new GraphScale();
            Assert.That(scale.Place(3f), Is.EqualTo(0.5f));

            scale.Fit(0f, 0f, 2f);

            Assert.That(scale.High - scale.Low, Is.EqualTo(2f));
            Assert.That(scale.Place(0f), Is.EqualTo(0.5f));
        }

        [Test]
        public void Curve_RunsFromSideToSide_AndThroughEverySample()
        {
            BeatSample[] beat = Beat(0.1, 0.3, 0.85);
            var curve = new GraphCurve(8);
            GraphScale scale = Scale();

            curve.Lay(beat, sample => sample.flap, scale, s_Area);

            Assert.That(curve.Count, Is.EqualTo(5));
            Assert.That(curve.Points[0].x, Is.EqualTo(s_Area.xMin).Within(1e-3f));
            Assert.That(curve.Points[4].x, Is.EqualTo(s_Area.xMax).Within(1e-3f));
            Assert.That(curve.Points[0].y, Is.EqualTo(curve.Points[4].y).Within(1e-3f), "the beat does not close");
            for (int k = 0; k < 3; k++)
                Assert.That(curve.Points[k + 1], Is.EqualTo(GraphCurve.At(s_Area, beat[k].Phase, scale.Place(beat[k].flap))));
        }

        [Test]
        public void Curve_StaysInItsRect()
        {
            var random = new System.Random(5);
            var curve = new GraphCurve(64);
            for (int round = 0; round < 200; round++)
            {
                double[] phases = new double[random.Next(1, 60)];
                for (int k = 0; k < phases.Length; k++)
                    phases[k] = random.NextDouble();
                Array.Sort(phases);

                curve.Lay(Beat(phases), sample => sample.flap, Scale(), s_Area);

                for (int k = 0; k < curve.Count; k++)
                {
                    Assert.That(curve.Points[k].x, Is.InRange(s_Area.xMin - 1e-2f, s_Area.xMax + 1e-2f));
                    Assert.That(curve.Points[k].y, Is.InRange(s_Area.yMin - 1e-2f, s_Area.yMax + 1e-2f));
                }
            }
        }

        [TestCase(0f, 0f, 10f, 70f)]
        [TestCase(1f, 0f, 210f, 70f)]
        [TestCase(0f, 1f, 10f, 20f)]
        [TestCase(0.25f, 0.2f, 60f, 60f)]
        public void APlaceOfTheGraph_RunsToTheRight_AndUpwards(float phase, float height, float x, float y) =>
            Assert.That((GraphCurve.At(s_Area, phase, height) - new Vector3(x, y, 0f)).magnitude, Is.LessThan(1e-4f));

        [Test]
        public void NoSamples_MakeNoLine()
        {
            var curve = new GraphCurve(8);
            curve.Lay(Beat(0.5), sample => sample.flap, Scale(), s_Area);
            curve.Lay(Beat(), sample => sample.flap, Scale(), s_Area);

            Assert.That(curve.Count, Is.Zero);
        }

        [Test]
        public void MeanLift_CountsTime_NotSamples()
        {
            // Nine samples crowd where the lift is 2, one where it is 0; the beat spends half its time at each.
            var beat = new BeatSample[20];
            for (int k = 0; k < 10; k++)
                beat[k] = new BeatSample(0.5 * k / 10, 0f, 2f);
            for (int k = 0; k < 10; k++)
                beat[10 + k] = new BeatSample(0.5 + 0.001 * k, 0f, 0f);

            Assert.That(LiveNumbers.MeanLift(beat), Is.EqualTo(1f + 0.45f).Within(0.06f));
            Assert.That(LiveNumbers.MeanLift(new[] { new BeatSample(0.3, 0f, 0.7f) }), Is.EqualTo(0.7f));
        }

        [Test]
        public void MeanLift_OfAWaveAroundOne_IsOne()
        {
            var random = new System.Random(9);
            double[] phases = new double[400];
            for (int k = 0; k < phases.Length; k++)
                phases[k] = random.NextDouble();
            Array.Sort(phases);
            BeatSample[] beat = Array.ConvertAll(
                phases, phase => new BeatSample(phase, 0f, 1f + 3f * Mathf.Sin(2f * Mathf.PI * (float)phase)));

            Assert.That(LiveNumbers.MeanLift(beat), Is.EqualTo(1f).Within(0.01f));
        }

        private static GraphScale Scale()
        {
            var scale = new GraphScale();
            scale.Fit(-60f, 60f, 1f);
            return scale;
        }

        private static BeatSample[] Beat(params double[] phases) =>
            Array.ConvertAll(phases, phase => new BeatSample(phase, 60f * Mathf.Cos(2f * Mathf.PI * (float)phase), 0f));
    }
}
