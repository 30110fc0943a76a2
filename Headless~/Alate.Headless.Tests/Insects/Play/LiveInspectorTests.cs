using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>The inspector and the gizmos of an insect that lives.</summary>
    public sealed class LiveInspectorTests : PlayFixture
    {
        private UnityEditor.Editor m_Editor;

        [TearDown]
        public void Close()
        {
            if (m_Editor != null)
                UnityEngine.Object.DestroyImmediate(m_Editor);
            Undo.ClearAll();
        }

        [UnityTest]
        public IEnumerator Graphs_ShowTheBeat_AndItsNumbers()
        {
            InsectWings insect = Insect();
            m_Editor = UnityEditor.Editor.CreateEditor(insect);
            yield return Watched(120);

            var page = DrawnInspector.Of(m_Editor);

            Assert.That(page.Control("Frequency").Value, Is.EqualTo("8.8 Hz"));
            Assert.That(page.Control("Flap Range").Value, Does.EndWith("°"));
            Assert.That(page.Control("Detail").Value, Is.EqualTo("Full"));
            Assert.That(page.Control("Resets").Value, Is.EqualTo("0"));
            Assert.That(LiveNumbers.Substeps(insect), Is.EqualTo($"{insect.Read(0).Substeps} in the last step"));
            Assert.That(LiveNumbers.Frequency(insect), Is.EqualTo("8.8 Hz"));
            Assert.That(page.Control("Mean Lift").Value, Does.Match(@"^-?\d\.\d\d of the weight$"));
            Assert.That(page.Controls.Count(c => c.Kind == ControlKind.Area), Is.GreaterThanOrEqualTo(6), "nothing was drawn");
        }

        // Yellow and blue are told apart with any weakness for red and green.
        [UnityTest]
        public IEnumerator Curves_DifferInYellowAndBlue()
        {
            m_Editor = UnityEditor.Editor.CreateEditor(Insect());
            yield return Watched(120);
            DrawnLines.Calls = new List<(Color Colour, Vector3[] Points)>();
            DrawnInspector.Of(m_Editor);
            Color[] curves = DrawnLines.Calls.Where(line => line.Points.Length > 2).Select(line => line.Colour).ToArray();
            DrawnLines.Calls = null;

            Assert.That(curves.Select(colour => Mathf.Sign(Mathf.Min(colour.r, colour.g) - colour.b)), Is.EqualTo(new[] { 1f, -1f }),
                "the flap angle is yellowish, the lift bluish");
            Assert.That(curves.Select(colour => colour.a), Is.All.EqualTo(1f));
        }

        // The force is the mean over a step: half a step old; steps that a script makes have no length that is known.
        [UnityTest]
        public IEnumerator AForce_LiesBackByHalfAStep_InBeats()
        {
            InsectWings insect = Insect();
            yield return Frames(20);
            foreach ((WingUpdateMode mode, double step) in new[]
            {
                (WingUpdateMode.Update, Clocks.FrameStep), (WingUpdateMode.FixedUpdate, Time.fixedDeltaTime), (WingUpdateMode.Manual, 0.0),
            })
            {
                insect.UpdateMode = mode;
                yield return Frames(3);
                Assert.That(BeatReader.ForceLag(insect), Is.EqualTo(0.5 * step * insect.Frequency).Within(1e-6), $"{mode}");
            }
        }

        [UnityTest]
        public IEnumerator FlapAngle_SwingsAsFarAsTheWingDoes()
        {
            InsectWings insect = Insect();
            var trace = new BeatTrace(512, 8.0);
            for (int frame = 0; frame < 120; frame++)
            {
                yield return null;
                if (BeatReader.TryRead(insect, out BeatSample sample))
                    trace.Add(sample);
            }

            BeatSample[] beat = trace.Fold().ToArray();

            // Driven through 60 degrees at rest; the tip bends a few more either way, and is highest early in the beat, lowest after half
            // of it.
            Assert.That(insect.FlapRange, Is.EqualTo(60f).Within(0.5f));
            float swing = beat.Max(s => s.flap) - beat.Min(s => s.flap);
            Assert.That(swing, Is.InRange(45f, 90f));
            Assert.That(beat.First(s => s.flap == beat.Max(t => t.flap)).Phase, Is.LessThan(0.2f).Or.GreaterThan(0.95f));
            Assert.That(beat.First(s => s.flap == beat.Min(t => t.flap)).Phase, Is.InRange(0.45f, 0.7f));
            Assert.That(LiveNumbers.MeanLift(trace.Fold(BeatReader.ForceLag(insect))), Is.EqualTo(beat.Average(s => s.lift)).Within(0.1f));
        }

        [UnityTest]
        public IEnumerator SliderInTheInspector_IsFelt_AndTheBeatGoesOn([Values] bool withSkeletons)
        {
            InsectWings insect = Insect();
            foreach (Wing authored in insect.Wings)
                authored.Skeleton = withSkeletons ? authored.Skeleton : null;
            m_Editor = UnityEditor.Editor.CreateEditor(insect);
            yield return Frames(60);
            LiveWing live = insect.Live.wings[0];
            int beats = insect.Read(0).Beats;
            float range = insect.Read(0).Amplitude.x;

            SerializedProperty wing = m_Editor.serializedObject.FindProperty("m_Wings").GetArrayElementAtIndex(0);
            wing.FindPropertyRelative("m_AmplitudeScale").floatValue = 0.5f;
            m_Editor.serializedObject.ApplyModifiedProperties();
            yield return Frames(60);

            Assert.That(insect.Live.wings[0], Is.SameAs(live), "the insect was rebuilt");
            Assert.That(insect.Read(0).Beats, Is.GreaterThan(beats));
            Assert.That(insect.Read(0).Amplitude.x, Is.EqualTo(0.5f * range).Within(0.02f * range));
            Assert.That(insect.Read(1).Amplitude.x, Is.EqualTo(range).Within(0.02f * range));

            Undo.PerformUndo();
            yield return Frames(60);
            Assert.That(insect.Live.wings[0], Is.SameAs(live), "undo rebuilt the insect");
            Assert.That(insect.Read(0).Amplitude.x, Is.EqualTo(range).Within(0.02f * range));
        }

        [UnityTest]
        public IEnumerator AuthoredMeshes_ComeBack_AfterTheListWasEdited()
        {
            InsectWings insect = Insect();
            Mesh authored = Shown(insect, 0);
            m_Editor = UnityEditor.Editor.CreateEditor(insect);
            yield return Frames(5);
            m_Editor.serializedObject.FindProperty("m_Wings").GetArrayElementAtIndex(0)
                .FindPropertyRelative("m_PhaseLead").floatValue = 30f;
            m_Editor.serializedObject.ApplyModifiedProperties();
            yield return Frames(5);

            insect.enabled = false;

            Assert.That(Shown(insect, 0), Is.SameAs(authored));
            Assert.That(insect.Wings[0].Authored == null, Is.True);
        }

        [UnityTest]
        public IEnumerator Gizmos_FollowTheLivingJoints()
        {
            InsectWings insect = Insect();
            yield return Frames(31);
            yield return new WaitForEndOfFrame();

            RecordingPen pen = Draw(insect, GizmoLayers.Chains);

            Assert.That(pen.Dots, Has.Count.EqualTo(50));
            foreach ((int chain, int joint) in new[] { (0, 4), (2, 3), (4, 4) })
            {
                Vector3 rest = insect.Wings[1].Skeleton.GetJoint(chain, joint);
                Vector3 expected = insect.Wings[1].Renderer.transform.TransformPoint(NearestVertex(insect, 1, rest));
                Assert.That(pen.Dots.Min(dot => (dot.at - expected).magnitude), Is.LessThan(0.02f),
                    $"joint {chain}, {joint} is off the drawn wing");
            }
        }

        [UnityTest]
        public IEnumerator AirForces_AreAsLongAsTheWing_WhereOneCarriesTheInsect()
        {
            InsectWings insect = Insect();
            yield return Frames(30);
            LiveWing live = insect.Live.wings[0];
            float weight = live.values.size.insectMass * Physics.gravity.magnitude;

            RecordingPen pen = Draw(insect, GizmoLayers.Force);

            Vector3 expected = insect.AirForceOf(0) * (live.placed.length / weight);
            Assert.That(expected.magnitude, Is.GreaterThan(0f));
            Assert.That((pen.Lines[0].to - pen.Lines[0].from - expected).magnitude, Is.LessThan(1e-4f * expected.magnitude));
            Vector3 middle = Draw(insect, GizmoLayers.Chains).Dots[2 * 5 + 2].at;
            Assert.That((pen.Lines[0].from - middle).magnitude, Is.LessThan(1e-5f), "from the middle joint of the middle chain");
        }

        [UnityTest]
        public IEnumerator PatchLoads_StartOnTheWings_AndAreInProportion()
        {
            InsectWings insect = Insect();
            yield return Frames(30);
            Draw(insect, GizmoLayers.Loads);
            yield return Frames(2);
            yield return new WaitForEndOfFrame();
            WingReading reading = insect.Read(0);

            List<(Vector3 from, Vector3 to, Color colour)> lines = Draw(insect, GizmoLayers.Loads).Lines;

            Assert.That(lines, Has.Count.EqualTo(2 * reading.PatchCount));
            Bounds wing = insect.BoundsOf(0);
            wing.Expand(0.01f);
            Transform space = insect.Wings[0].Renderer.transform;
            int strongest = Enumerable.Range(0, reading.PatchCount).OrderBy(patch => math.length(reading.PatchForce(patch))).Last();
            float scale = Length(lines[strongest]) / math.length(reading.PatchForce(strongest));
            Assert.That(Length(lines[strongest]), Is.InRange(0.01f, 2f), "the loads are too small or too large to be seen");
            for (int patch = 0; patch < reading.PatchCount; patch++)
            {
                Assert.That(wing.Contains(space.InverseTransformPoint(lines[patch].from)), Is.True, $"patch {patch} lies beside the wing");
                Assert.That(Length(lines[patch]), Is.EqualTo(scale * math.length(reading.PatchForce(patch))).Within(1e-4f));
            }
        }

        [UnityTest]
        public IEnumerator PatchLoads_AreKeptOnlyWhileTheyAreDrawn()
        {
            InsectWings insect = Insect();
            yield return Frames(5);
            Assert.That(insect.Read(0).HasPatchLoads, Is.False);

            Draw(insect, GizmoLayers.Loads);
            Assert.That(insect.Read(0).HasPatchLoads, Is.True);
            yield return Frames(2);

            Draw(insect, GizmoLayers.Chains);
            Assert.That(insect.Read(0).HasPatchLoads, Is.False);
        }

        [UnityTest]
        public IEnumerator PatchLoads_AreKeptNoLongerThanTheInsectIsSelected()
        {
            InsectWings insect = Insect();
            Selection.activeGameObject = insect.gameObject;
            yield return Frames(5);
            Draw(insect, GizmoLayers.Loads);
            Selection.objects = new Object[] { insect.gameObject, insect.Wings[0].Renderer.gameObject };
            Assert.That(insect.Read(0).HasPatchLoads, Is.True);

            Selection.activeObject = null;

            Assert.That(insect.Read(0).HasPatchLoads || insect.Read(1).HasPatchLoads, Is.False);
        }

        [UnityTest]
        public IEnumerator AWingAddedWhileTheGameIsPaused_TroublesNoGizmo()
        {
            InsectWings insect = Insect();
            yield return Frames(5);
            insect.Wings.Add(new Wing());

            Assert.That(() => Draw(insect, (GizmoLayers)63), Throws.Nothing);
            insect.Wings.RemoveAt(2);
        }

        [UnityTest]
        public IEnumerator Velocity_IsAsLongAsTheWayOfOneBeat()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Script;
            insect.Velocity = new Vector3(0f, 0f, 5f);
            yield return Frames(60);

            RecordingPen pen = Draw(insect, GizmoLayers.Velocity);

            (Vector3 from, Vector3 to, Color colour) line = pen.Lines.First(l => l.colour == GizmoColours.Velocity);
            Assert.That((line.to - line.from).z, Is.EqualTo(5f / insect.Frequency).Within(1e-3f));
        }

        [UnityTest]
        public IEnumerator Bounds_AreThoseOfTheDeformedPart()
        {
            InsectWings insect = Insect();
            yield return Frames(20);

            RecordingPen pen = Draw(insect, GizmoLayers.Bounds);

            Assert.That(pen.Boxes[0].bounds, Is.EqualTo(insect.BoundsOf(0)));
        }

        [UnityTest]
        public IEnumerator Resting_IsExplained()
        {
            InsectWings insect = Insect();
            insect.Quality.culling = WingCulling.CullCompletely;
            yield return Frames(10);

            var status = InsectStatus.Of(insect);

            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Frozen));
            Assert.That(status.Kind, Is.EqualTo(MessageType.Info));
            Assert.That(status.Message, Does.Contain("no camera"));
        }

        [UnityTest]
        public IEnumerator WaitingAndBrokenInsects_SayWhy()
        {
            InsectWings insect = Insect();
            Assert.That(InsectStatus.Of(insect).Message, Does.Contain("next frames"));
            yield return Frames(2);
            Assert.That(InsectStatus.Of(insect).IsShown, Is.False);

            insect.transform.localScale = Vector3.zero;
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("scale of zero"));
            yield return Frames(2);

            Assert.That(InsectStatus.Of(insect).Kind, Is.EqualTo(MessageType.Warning));
            Assert.That(InsectStatus.Of(insect).Message, Does.Contain("scale of zero"));
        }

        [UnityTest]
        public IEnumerator StaticBatching_CannotBeMendedWhilePlaying()
        {
            InsectWings insect = Insect();
            yield return Frames(2);

            Assert.That(new StaticBatchingFix().FindObstacle(insect, InsectProblem.None), Does.Contain("Stop playing"));
        }

        private static float Length((Vector3 from, Vector3 to, Color colour) line) => (line.to - line.from).magnitude;

        // Where the vertex is drawn that is nearest to a place at rest; living meshes have their vertices in the rig's order.
        private static Vector3 NearestVertex(InsectWings insect, int wing, Vector3 rest)
        {
            Vector3[] authored = insect.Wings[wing].Authored.vertices, drawn = Shown(insect, wing).vertices;
            int[] order = Order(insect, wing);
            int nearest = Enumerable.Range(0, order.Length).OrderBy(v => (authored[order[v]] - rest).sqrMagnitude).First();
            return drawn[nearest];
        }

        private IEnumerator Watched(int frames)
        {
            for (int frame = 0; frame < frames; frame++)
            {
                yield return null;
                EditorApplication.update?.Invoke();
            }
        }

        private static RecordingPen Draw(InsectWings insect, GizmoLayers layers)
        {
            var pen = new RecordingPen();
            InsectDrawing.Draw(insect, layers, pen);
            return pen;
        }
    }
}
