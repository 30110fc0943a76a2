using System;
using System.Collections;
using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Wakes of living insects in the scene view.</summary>
    public sealed class WakeGizmoLaws : PlayFixture
    {
        private static float3 At(double beat) => new((float)Math.Cos(2.0 * Math.PI * beat), (float)Math.Sin(2.0 * Math.PI * beat), 1f);

        [Test]
        public void FramesOfSeveralBeats_AreFoldedIntoOne()
        {
            var trace = new JointTrace();
            for (int k = 0; k < 71; k++)
                trace.Add(k * 8.0 / 71.0, [At(k * 8.0 / 71.0), default]);

            // Nine frames a beat, 71 phases in eight of them: lines between them are off by (2π/71)²/8.
            Assert.That(trace.TrySample(24, out float3[][] even), Is.True);
            for (int k = 0; k < 24; k++)
            {
                Assert.That(math.distance(even[k][0], At(k / 24.0)), Is.LessThan(2e-3f), $"phase {k}");
                Assert.That(even[k][1], Is.EqualTo(float3.zero));
            }
        }

        [Test]
        public void ABeatWithAGap_IsNone_AndAnotherBeatBeginsAgain()
        {
            var trace = new JointTrace();
            Assert.That(trace.TrySample(8, out _), Is.False, "no frame");
            foreach (double beat in new[] { 0.1, 0.3, 0.5, 0.7 })
                trace.Add(beat, [At(beat)]);
            Assert.That(trace.TrySample(8, out _), Is.False, "0.4 of the beat is missing");
            trace.Add(1.9, [At(1.9)]);
            Assert.That(trace.TrySample(8, out _), Is.True);
            trace.Add(0.2, [At(0.2)]);
            Assert.That(trace.TrySample(8, out _), Is.False, "time that goes back is another flight");
        }

        [UnityTest]
        public IEnumerator AWake_LiesBehindTheInsect_AndGoesWithItsLayer()
        {
            Time.captureDeltaTime = 0.013f;
            InsectWings insect = Insect();
            insect.transform.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f));
            // A head wind, to an insect that looks along x.
            insect.Air.wind = new Vector3(-13f, 0f, 0f);
            yield return Frames(3);
            Assert.That(Draw(insect, GizmoLayers.Wake).Lines, Is.Empty, "not yet");
            for (int frame = 0; frame < 90; frame++)
            {
                Draw(insect, GizmoLayers.Wake);
                yield return null;
            }

            RecordingPen pen = Draw(insect, GizmoLayers.Wake);
            Vector3[] places = [.. pen.Lines.SelectMany(line => new[] { line.from, line.to })];
            Assert.That(places.All(place => math.all(math.isfinite((float3)place))));
            float length = insect.Live.wings[0].placed.length, beat = 13f / insect.Frequency;
            Assert.That(places.Min(place => place.x - 1f), Is.LessThan(-1.2f * beat), "carried by the wind for a beat and a half");
            Assert.That(places.Max(place => place.x - 1f), Is.LessThan(1.2f * length), "nothing ahead of the wings");
            Assert.That(places.Min(place => place.z - 3f), Is.EqualTo(-places.Max(place => place.z - 3f)).Within(0.05f * length), "even");
            Assert.That(pen.Lines.Select(line => line.colour.a), Is.All.InRange(0.049f, 0.801f));
            Assert.That(pen.Lines.Max(line => line.colour.a), Is.GreaterThan(0.6f));

            // A second picture of a frame does no second step, and what does not play has no wake.
            Assert.That(Draw(insect, GizmoLayers.Wake).Lines, Has.Count.EqualTo(pen.Lines.Count));
            Assert.That(Draw(insect, GizmoLayers.None).Lines, Is.Empty);
            Assert.That(Draw(insect, GizmoLayers.Wake).Lines, Is.Empty, "it began again");
            insect.enabled = false;
            Assert.That(Draw(insect, GizmoLayers.Wake).Lines, Is.Empty);
        }

        [UnityTest]
        public IEnumerator AWake_GoesWithTheSelection()
        {
            Time.captureDeltaTime = 0.013f;
            InsectWings insect = Insect();
            Selection.activeGameObject = insect.gameObject;
            for (int frame = 0; frame < 90; frame++)
            {
                Draw(insect, GizmoLayers.Wake);
                yield return null;
            }

            Assert.That(Draw(insect, GizmoLayers.Wake).Lines, Is.Not.Empty);
            Selection.activeGameObject = null;
            Assert.That(Draw(insect, GizmoLayers.Wake).Lines, Is.Empty);
            Draw(insect, GizmoLayers.None);
        }

        private static RecordingPen Draw(InsectWings insect, GizmoLayers layers)
        {
            var pen = new RecordingPen();
            InsectDrawing.Draw(insect, layers, pen);
            return pen;
        }
    }
}
