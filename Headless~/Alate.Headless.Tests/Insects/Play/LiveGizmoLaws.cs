using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Laws of the gizmos and the graphs of an insect that lives.</summary>
    public sealed class LiveGizmoLaws : PlayFixture
    {
        [UnityTest]
        public IEnumerator AxesOfALivingWing_AreThoseOfItsSkeleton_WithTheBody()
        {
            InsectWings insect = Insect();
            insect.transform.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 50f, 20f));
            yield return Frames(10);
            RecordingPen pen = Draw(insect, GizmoLayers.Axes), chains = Draw(insect, GizmoLayers.Chains);
            for (int wing = 0; wing < 2; wing++)
            {
                Transform place = insect.Wings[wing].Renderer.transform;
                WingSkeleton skeleton = insect.Wings[wing].Skeleton;
                Vector3 hinge = place.TransformPoint(skeleton.Hinge);
                Assert.That((pen.Dots[wing].at - hinge).magnitude, Is.LessThan(1e-4f));
                Assert.That(pen.Dots[wing].colour, Is.EqualTo(GizmoColours.Hinge));
                float length = 0.35f * (chains.Dots[25 * wing + 4].at - chains.Dots[25 * wing].at).magnitude;
                foreach ((int line, Vector3 axis, Color colour) in new[]
                {
                    (6 * wing, skeleton.SpanAxis, GizmoColours.Span), (6 * wing + 3, skeleton.UpAxis, GizmoColours.Up),
                })
                {
                    Assert.That(pen.Lines[line].colour, Is.EqualTo(colour));
                    Assert.That((pen.Lines[line].from - hinge).magnitude, Is.LessThan(1e-4f));
                    Vector3 arrow = pen.Lines[line].to - pen.Lines[line].from;
                    Assert.That((arrow - length * place.TransformDirection(axis.normalized)).magnitude,
                        Is.LessThan(1e-4f), $"{wing}, {axis}");
                }
            }
        }

        [UnityTest]
        public IEnumerator ALoad_IsFifteenHundredthsOfTheWing_ForAnEvenShareOfTheWeight()
        {
            InsectWings insect = Insect();
            yield return Frames(30);
            Draw(insect, GizmoLayers.Loads);
            yield return Frames(2);
            yield return new WaitForEndOfFrame();
            List<(Vector3 from, Vector3 to, Color colour)> lines = Draw(insect, GizmoLayers.Loads).Lines;
            int at = 0;
            for (int wing = 0; wing < 2; wing++)
            {
                LiveWing live = insect.Live.wings[wing];
                PresetSize size = live.values.size;
                WingReading reading = insect.Read(wing);
                for (int patch = 0; patch < reading.PatchCount; patch++, at++)
                {
                    Vector3 newtons = size.wingMass * size.wingLength * live.placed.ToWorld(reading.PatchForce(patch));
                    float share = newtons.magnitude / (size.insectMass * Physics.gravity.magnitude / reading.PatchCount);
                    Vector3 arrow = lines[at].to - lines[at].from;
                    Assert.That(arrow.magnitude, Is.EqualTo(0.15f * live.placed.length * share).Within(1e-5f), $"{wing}, {patch}");
                    Assert.That(Vector3.Dot(arrow, newtons), Is.GreaterThanOrEqualTo(0.99f * arrow.magnitude * newtons.magnitude));
                    Assert.That(lines[at].colour, Is.EqualTo(GizmoColours.Load));
                    Vector3 place = live.transform.TransformPoint(live.rig.Frame.ToMesh(reading.PatchPosition(patch, insect.DrawnAlpha)));
                    Assert.That((lines[at].from - place).magnitude, Is.LessThan(1e-5f));
                }
            }

            Assert.That(lines, Has.Count.EqualTo(at));
        }

        [UnityTest]
        public IEnumerator WindAndVelocity_StartAtTheBody_AndAreTheWayOfABeat_AlsoStraightUp([Values] bool up)
        {
            InsectWings insect = Insect();
            insect.transform.position = new Vector3(2f, 3f, 4f);
            Vector3 wind = up ? new Vector3(0f, 2f, 0f) : new Vector3(1.5f, 0.5f, 0f);
            insect.Air.wind = wind;
            yield return Frames(30);
            RecordingPen pen = Draw(insect, GizmoLayers.Velocity);

            (Vector3 from, Vector3 to, Color colour)[] arrow = pen.Lines.Where(line => line.colour == GizmoColours.Wind).ToArray();
            Assert.That(arrow, Has.Length.EqualTo(3));
            Assert.That(pen.Lines, Has.Count.EqualTo(3), "it does not move");
            Assert.That((arrow[0].from - insect.transform.position).magnitude, Is.LessThan(1e-5f));
            Vector3 way = arrow[0].to - arrow[0].from;
            Assert.That((way - wind / insect.Frequency).magnitude, Is.LessThan(1e-4f));
            Assert.That((arrow[1].to - arrow[2].to).magnitude,
                Is.EqualTo(0.12f * way.magnitude).Within(1e-5f), "a head that is as wide as long");
            Assert.That(Vector3.Dot(arrow[1].to - arrow[2].to, way), Is.EqualTo(0f).Within(1e-5f));
        }

        [UnityTest]
        public IEnumerator WithoutWeight_ThereIsNoMeasureForForces()
        {
            InsectWings insect = Insect();
            yield return Frames(10);
            Assert.That(Draw(insect, GizmoLayers.Force).Lines, Has.Count.EqualTo(6));
            Physics.gravity = Vector3.zero;
            Assert.That(Draw(insect, GizmoLayers.Force | GizmoLayers.Loads).Lines, Is.Empty);
        }

        [UnityTest]
        public IEnumerator ADelay_IsColouredAlikeInPlayAndAtRest()
        {
            InsectWings insect = Insect();
            insect.enabled = false;
            Color[] rest = Draw(insect, GizmoLayers.Chains).Dots.Select(dot => dot.colour).ToArray();
            Color[] bones = Draw(insect, GizmoLayers.Chains).Lines.Select(line => line.colour).ToArray();
            insect.enabled = true;
            yield return Frames(5);
            RecordingPen pen = Draw(insect, GizmoLayers.Chains);
            for (int k = 0; k < rest.Length; k++)
                Assert.That(Apart(pen.Dots[k].colour, rest[k]), Is.LessThan(1e-3f), $"joint {k}");
            for (int k = 0; k < bones.Length; k++)
            {
                Assert.That(Apart(pen.Lines[k].colour, bones[k]), Is.LessThan(1e-3f), $"bone {k}");
                int wing = k / 20, chain = k % 20 / 4, joint = k % 4;
                var sketch = ChainSketch.Of(insect, wing);
                float middle = 0.5f * (sketch.Delay(chain, joint) + sketch.Delay(chain, joint + 1));
                Assert.That(Apart(bones[k], GizmoColours.Delay(middle)), Is.LessThan(1e-3f), "a bone has the delay of its middle");
                Assert.That((pen.Lines[k].from, pen.Lines[k].to), Is.EqualTo((sketch.Joint(chain, joint), sketch.Joint(chain, joint + 1))));
            }

            float Apart(Color a, Color b) => Mathf.Abs(a.r - b.r) + Mathf.Abs(a.g - b.g) + Mathf.Abs(a.b - b.b) + Mathf.Abs(a.a - b.a);
        }

        [UnityTest]
        public IEnumerator APanel_HasSomethingNewOnceAFrame_AndOnceMoreWhenTheWingsEnd()
        {
            // Longer than a step of the wings: frames as long as one have none or two where their times are rounded.
            Time.captureDeltaTime = 1f / 50f;
            InsectWings insect = Insect();
            var panel = new LivePanel();
            Assert.That(panel.Refresh(insect), Is.False, "not yet");
            yield return Frames(5);
            Assert.That((panel.Refresh(insect), panel.Refresh(insect), panel.Trace.Count), Is.EqualTo((true, false, 1)));
            yield return Frames(1);
            Assert.That((panel.Refresh(insect), panel.Trace.Count), Is.EqualTo((true, 2)));
            WingReading wing = insect.Read(0);
            Assert.That(panel.Trace.Last.beat, Is.EqualTo(wing.Beats + wing.Phase / (2.0 * math.PI_DBL)).Within(1e-6));
            Assert.That(panel.Trace.Last.lift, Is.EqualTo(insect.LiftOverWeight));
            float3 tip = wing.JointPosition(0, 4);
            Assert.That(math.tan(math.radians(panel.Trace.Last.flap)) * tip.x, Is.EqualTo(tip.y).Within(1e-4f));
            insect.enabled = false;
            Assert.That((panel.Refresh(insect), panel.Refresh(insect), panel.Trace.Count), Is.EqualTo((true, false, 0)));
        }

        private static RecordingPen Draw(InsectWings insect, GizmoLayers layers)
        {
            var pen = new RecordingPen();
            InsectDrawing.Draw(insect, layers, pen);
            return pen;
        }
    }
}
