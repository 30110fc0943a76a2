using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Gizmos of insects that are edited; those of living ones are tested in play.</summary>
    public sealed class InsectDrawingTests : InsectFixture
    {
        [Test]
        public void Chains_AreDrawnWhereTheJointsAre()
        {
            InsectWings insect = Insect();
            insect.transform.SetPositionAndRotation(new Vector3(3f, 4f, 5f), Quaternion.Euler(10f, 200f, 30f));
            insect.transform.localScale = new Vector3(2f, 2f, -2f);

            RecordingPen pen = Draw(insect, GizmoLayers.Chains);

            Assert.That(pen.Dots, Has.Count.EqualTo(2 * 25));
            Assert.That(pen.Lines, Has.Count.EqualTo(2 * 20));
            Wing left = insect.Wings[1];
            Vector3 expected = left.Renderer.transform.TransformPoint(left.Skeleton.GetJoint(3, 2));
            Assert.That(pen.Dots.Min(dot => (dot.at - expected).magnitude), Is.LessThan(1e-4f));
        }

        [Test]
        public void Colours_RunFromLeadingToTrailingEdge_AndFromRootToTip()
        {
            InsectWings insect = Insect();
            var sketch = ChainSketch.Of(insect, 0);

            Assert.That(sketch.Delay(0, 0), Is.Zero);
            Assert.That(sketch.Delay(4, 4), Is.EqualTo(1f).Within(1e-5f));
            for (int i = 0; i < 5; i++)
            {
                for (int j = 0; j < 4; j++)
                {
                    Assert.That(sketch.Delay(i, j + 1), Is.GreaterThan(sketch.Delay(i, j)));
                    Assert.That(i == 4 || sketch.Delay(i + 1, j) > sketch.Delay(i, j), Is.True);
                }
            }

            Assert.That(GizmoColours.Delay(0f), Is.Not.EqualTo(GizmoColours.Delay(1f)));
        }

        [Test]
        public void AColour_IsMixedOfTheNearestTwoOfEarlyMiddleAndLate_AndGoesNoFarther()
        {
            Color early = GizmoColours.Delay(0f), middle = GizmoColours.Delay(0.5f), late = GizmoColours.Delay(1f);

            Assert.That((Same(early, GizmoColours.Delay(-2f)), Same(late, GizmoColours.Delay(3f))), Is.EqualTo((true, true)));
            for (int k = 0; k <= 10; k++)
            {
                Assert.That(Same(GizmoColours.Delay(0.05f * k), Color.Lerp(early, middle, 0.1f * k)), $"{k} of 20");
                Assert.That(Same(GizmoColours.Delay(0.5f + 0.05f * k), Color.Lerp(middle, late, 0.1f * k)), $"{10 + k} of 20");
            }

            // Lightness falls all the way, so that the order can be told without hue (Rec. 709).
            float Light(Color colour) => 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
            Assert.That((early.r > early.b, late.b > late.r, Light(early) > Light(middle), Light(middle) > Light(late)),
                Is.EqualTo((true, true, true, true)));
        }

        private static bool Same(Color one, Color other) =>
            Mathf.Abs(one.r - other.r) + Mathf.Abs(one.g - other.g) + Mathf.Abs(one.b - other.b) + Mathf.Abs(one.a - other.a) < 1e-4f;

        [Test]
        public void WithoutDelayAlongTheSpan_EachChainHasOneColour()
        {
            InsectWings insect = Insect();
            insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            insect.Preset.Wave.spanDelay = 0f;

            var sketch = ChainSketch.Of(insect, 1);

            for (int i = 0; i < 5; i++)
                Assert.That(sketch.Delay(i, 4), Is.EqualTo(sketch.Delay(i, 0)));
            Assert.That(sketch.Delay(4, 0), Is.EqualTo(1f).Within(1e-5f));
        }

        [Test]
        public void WithoutAnyDelay_ChainsAreStillToldApart()
        {
            InsectWings insect = Insect();
            insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            insect.Preset.Wave.spanDelay = 0f;
            insect.Preset.Wave.chordDelay = 0f;

            Assert.That(ChainSketch.Of(insect, 0).Delay(4, 2), Is.EqualTo(1f).Within(1e-5f));
        }

        [Test]
        public void Axes_StartAtTheHinge()
        {
            InsectWings insect = Insect();
            insect.transform.position = new Vector3(0f, 9f, 0f);

            RecordingPen pen = Draw(insect, GizmoLayers.Axes);

            Wing right = insect.Wings[0];
            Vector3 hinge = right.Renderer.transform.TransformPoint(right.Skeleton.Hinge);
            Assert.That((pen.Dots[0].at - hinge).magnitude, Is.LessThan(1e-5f));
            (Vector3 from, Vector3 to, Color colour) span = pen.Lines.First(line => line.colour == GizmoColours.Span);
            Assert.That((span.from - hinge).magnitude, Is.LessThan(1e-5f));
            Assert.That(span.to.x, Is.GreaterThan(hinge.x), "the right wing's span goes to the right");
        }

        [Test]
        public void AnAxis_IsAnArrow_OfAThirdOfTheFirstChain_WithAHeadOfTwelveHundredths()
        {
            InsectWings insect = Insect();
            insect.transform.SetPositionAndRotation(new Vector3(3f, 4f, 5f), Quaternion.Euler(10f, 200f, 30f));
            RecordingPen pen = Draw(insect, GizmoLayers.Axes);
            Wing right = insect.Wings[0];
            Vector3 chain = right.Skeleton.GetJoint(0, 4) - right.Skeleton.GetJoint(0, 0);

            foreach (Color colour in new[] { GizmoColours.Span, GizmoColours.Up })
            {
                (Vector3 from, Vector3 to, Color colour)[] lines = pen.Lines.Where(line => line.colour == colour).Take(3).ToArray();
                Vector3 arrow = lines[0].to - lines[0].from;
                Vector3 axis = colour == GizmoColours.Span ? right.Skeleton.SpanAxis : right.Skeleton.UpAxis;
                Assert.That((arrow - 0.35f * chain.magnitude * right.Renderer.transform.TransformDirection(axis).normalized).magnitude,
                    Is.LessThan(1e-5f));
                foreach ((Vector3 from, Vector3 to, Color _) in lines.Skip(1))
                {
                    Assert.That(from, Is.EqualTo(lines[0].to));
                    Assert.That(Vector3.Dot(to - from, arrow.normalized), Is.EqualTo(-0.12f * arrow.magnitude).Within(1e-5f));
                    Assert.That(Vector3.Cross(to - from, arrow.normalized).magnitude, Is.EqualTo(0.06f * arrow.magnitude).Within(1e-5f));
                }

                Assert.That((lines[1].to - lines[2].to).magnitude, Is.EqualTo(0.12f * arrow.magnitude).Within(1e-5f), "on both sides");
            }
        }

        [Test]
        public void Bounds_AreThoseOfTheMeshes()
        {
            InsectWings insect = Insect();

            RecordingPen pen = Draw(insect, GizmoLayers.Bounds);

            Assert.That(pen.Boxes, Has.Count.EqualTo(2));
            Assert.That(pen.Boxes[0].bounds, Is.EqualTo(MeshOf(insect.Wings[0]).bounds));
            Assert.That(pen.Boxes[0].space, Is.EqualTo(insect.Wings[0].Renderer.transform.localToWorldMatrix));
        }

        [Test]
        public void OutOfPlay_ThereAreNoForces()
        {
            RecordingPen pen = Draw(Insect(), GizmoLayers.Force | GizmoLayers.Loads | GizmoLayers.Velocity);

            Assert.That(pen.Lines, Is.Empty);
        }

        [Test]
        public void BrokenWings_AreSkipped()
        {
            InsectWings insect = Insect();
            insect.Wings[0].Renderer = null;
            insect.Wings[1].Skeleton.Chains = new JointChain[0];
            insect.Wings.Add(new Wing());

            RecordingPen pen = Draw(insect, (GizmoLayers)~0);

            Assert.That(pen.Dots, Is.Empty);
            Assert.That(pen.Boxes, Has.Count.EqualTo(1));
        }

        private static RecordingPen Draw(InsectWings insect, GizmoLayers layers)
        {
            var pen = new RecordingPen();
            InsectDrawing.Draw(insect, layers, pen);
            return pen;
        }
    }
}
