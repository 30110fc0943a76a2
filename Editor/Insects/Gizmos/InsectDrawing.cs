using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws the layers of an insect: joints, axes, forces, motion, bounds; at rest where the wings do not live.</summary>
    internal static class InsectDrawing
    {
        /// <summary>Length of an axis over that of the leading edge.</summary>
        private const float k_AxisShare = 0.35f;

        /// <summary>Length of the arrow, in wing lengths, for a patch's even share of the insect's weight.</summary>
        private const float k_LoadShare = 0.15f;

        /// <summary>Length of an arrow's head over that of the arrow.</summary>
        private const float k_Head = 0.12f;

        /// <summary>Draws the chosen layers of all wings.</summary>
        public static void Draw(InsectWings insect, GizmoLayers layers, IGizmoPen pen)
        {
            // An edited list is followed in the next frame, which a paused game does not have.
            int count = insect.Live == null ? insect.Wings.Count : Mathf.Min(insect.Wings.Count, insect.Live.wings.Length);
            for (int wing = 0; wing < count; wing++)
            {
                if (insect.Wings[wing] == null)
                    continue;
                if ((layers & (GizmoLayers.Chains | GizmoLayers.Axes)) != 0)
                    DrawChains(insect, wing, layers, pen);
                if ((layers & GizmoLayers.Bounds) != 0)
                    DrawBounds(insect, wing, pen);
            }

            if (insect.Live == null)
            {
                WakeGizmo.Drop(insect);
                return;
            }

            for (int wing = 0; wing < insect.Live.wings.Length; wing++)
                DrawForces(insect, wing, layers, pen);
            if ((layers & GizmoLayers.Velocity) != 0)
                DrawMotion(insect, pen);
            if ((layers & GizmoLayers.Wake) != 0)
                WakeGizmo.Draw(insect, pen);
            else
                WakeGizmo.Drop(insect);
        }

        private static void DrawChains(InsectWings insect, int wing, GizmoLayers layers, IGizmoPen pen)
        {
            var sketch = ChainSketch.Of(insect, wing);
            if (sketch == null)
                return;
            if ((layers & GizmoLayers.Axes) != 0)
                DrawAxes(insect, wing, sketch, pen);
            if ((layers & GizmoLayers.Chains) == 0)
                return;
            for (int i = 0; i < sketch.ChainCount; i++)
            {
                for (int j = 0; j < sketch.JointsPerChain; j++)
                {
                    pen.Dot(sketch.Joint(i, j), GizmoColours.Delay(sketch.Delay(i, j)));
                    if (j == 0)
                        continue;
                    float delay = 0.5f * (sketch.Delay(i, j - 1) + sketch.Delay(i, j));
                    pen.Line(sketch.Joint(i, j - 1), sketch.Joint(i, j), GizmoColours.Delay(delay), true);
                }
            }
        }

        private static void DrawAxes(InsectWings insect, int wing, ChainSketch sketch, IGizmoPen pen)
        {
            Vector3 hinge, span, up;
            if (insect.Live != null)
            {
                PlacedWing placed = insect.Live.wings[wing].placed;
                hinge = placed.hinge;
                span = placed.span;
                up = placed.up;
            }
            else
            {
                WingSkeleton skeleton = insect.Wings[wing].Skeleton;
                Transform transform = insect.Wings[wing].Renderer.transform;
                hinge = transform.TransformPoint(skeleton.Hinge);
                span = transform.TransformVector(skeleton.SpanAxis).normalized;
                up = transform.TransformVector(skeleton.UpAxis).normalized;
            }

            float length = k_AxisShare * (sketch.Joint(0, sketch.JointsPerChain - 1) - sketch.Joint(0, 0)).magnitude;
            pen.Dot(hinge, GizmoColours.Hinge);
            DrawArrow(hinge, span * length, GizmoColours.Span, pen);
            DrawArrow(hinge, up * length, GizmoColours.Up, pen);
        }

        private static void DrawBounds(InsectWings insect, int wing, IGizmoPen pen)
        {
            MeshRenderer renderer = insect.Wings[wing].Renderer;
            if (renderer == null)
                return;
            Mesh mesh = InsectCheck.MeshOf(insect.Wings[wing], InsectCheck.FilterOf(insect.Wings[wing]));
            if (insect.Live != null)
                pen.Box(renderer.transform.localToWorldMatrix, insect.BoundsOf(wing), GizmoColours.Bounds);
            else if (mesh != null)
                pen.Box(renderer.transform.localToWorldMatrix, mesh.bounds, GizmoColours.Bounds);
        }

        private static void DrawForces(InsectWings insect, int wing, GizmoLayers layers, IGizmoPen pen)
        {
            LiveWing live = insect.Live.wings[wing];
            bool loads = (layers & GizmoLayers.Loads) != 0;
            if (insect.Read(wing).HasPatchLoads != loads)
                LoadRecording.Set(insect, wing, loads);
            float weight = live.values.size.insectMass * Physics.gravity.magnitude;
            if (weight <= 0f || !live.placed.isValid)
                return;
            if ((layers & GizmoLayers.Force) != 0)
            {
                // As long as the wing where one wing alone would carry the insect.
                WingReading reading = insect.Read(wing);
                float3 centre = reading.JointPosition(reading.ChainCount / 2, reading.JointsPerChain / 2, insect.DrawnAlpha);
                Vector3 middle = live.transform.TransformPoint(live.rig.Frame.ToMesh(centre));
                DrawArrow(middle, insect.AirForceOf(wing) * (live.placed.length / weight), GizmoColours.Force, pen);
            }

            if (loads)
                DrawLoads(insect, wing, weight, pen);
        }

        private static void DrawLoads(InsectWings insect, int wing, float weight, IGizmoPen pen)
        {
            LiveWing live = insect.Live.wings[wing];
            WingReading reading = insect.Read(wing);
            float newtons = live.values.size.wingMass * live.values.size.wingLength;
            float scale = k_LoadShare * live.placed.length * reading.PatchCount * newtons / weight;
            float alpha = insect.DrawnAlpha;
            for (int patch = 0; patch < reading.PatchCount; patch++)
            {
                Vector3 at = live.transform.TransformPoint(live.rig.Frame.ToMesh(reading.PatchPosition(patch, alpha)));
                pen.Line(at, at + (Vector3)live.placed.ToWorld(reading.PatchForce(patch) * scale), GizmoColours.Load, false);
            }
        }

        // As long as the way of one beat.
        private static void DrawMotion(InsectWings insect, IGizmoPen pen)
        {
            BodyFlight flight = insect.Live.flight;
            float beat = 1f / math.max(insect.Frequency, 1e-3f);
            DrawArrow(flight.position, flight.velocity * beat, GizmoColours.Velocity, pen);
            DrawArrow(flight.position, flight.wind * beat, GizmoColours.Wind, pen);
        }

        private static void DrawArrow(Vector3 from, Vector3 arrow, Color colour, IGizmoPen pen)
        {
            float length = arrow.magnitude;
            if (!(length > 0f) || float.IsInfinity(length))
                return;
            Vector3 side = Vector3.Cross(arrow, Mathf.Abs(arrow.y) < 0.9f * length ? Vector3.up : Vector3.right).normalized;
            Vector3 tip = from + arrow, back = tip - k_Head * arrow;
            pen.Line(from, tip, colour, true);
            pen.Line(tip, back + 0.5f * k_Head * length * side, colour, true);
            pen.Line(tip, back - 0.5f * k_Head * length * side, colour, true);
        }
    }
}
