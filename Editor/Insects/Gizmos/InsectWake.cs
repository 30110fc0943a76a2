using System;
using System.Collections.Generic;
using Alate.Wake;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Wake of a living insect, as if it flew on as it does: the beat of its wings is gathered from frames, a free wake is stepped behind
    /// it once a frame, and each wake that is done is shown, phase by phase, until the next one is.
    /// </summary>
    internal sealed class InsectWake : IDisposable
    {
        private const int k_Steps = 24, k_Beats = 2, k_Strips = 6;

        /// <summary>
        /// Age at which a row is dropped, beats, and radius of an old core, chords, with which the wake rolls up into tubes.
        /// </summary>
        private const float k_Keep = 1.5f, k_FarCore = 0.8f;

        /// <summary>Opacity of the weakest and of the strongest rings.</summary>
        private const float k_Faintest = 0.05f, k_Densest = 0.8f;

        private readonly List<JointTrace> m_Traces = new List<JointTrace>();
        private FreeWake m_Wake;
        private Sheet[][] m_Next, m_Shown;
        private float m_Length, m_ShownLength, m_Strongest;
        private int m_Frame = -1;

        /// <summary>True where there is a wake to show.</summary>
        public bool IsShown => m_Shown != null;

        /// <inheritdoc/>
        public void Dispose()
        {
            m_Wake?.Dispose();
            m_Wake = null;
            m_Next = m_Shown = null;
        }

        /// <summary>Takes the wings of this frame, and does the next step; once a frame, however often it is called.</summary>
        public void Follow(InsectWings insect)
        {
            if (m_Frame == Time.frameCount)
                return;
            m_Frame = Time.frameCount;
            Gather(insect);
            if (m_Wake == null)
                Begin(insect);
            if (m_Wake == null)
                return;
            m_Wake.Step();
            if (m_Wake.StepCount > (k_Beats - 1) * k_Steps)
                m_Next[(m_Wake.StepCount - 1) % k_Steps] = Copy();
            if (m_Wake.StepCount == k_Beats * k_Steps)
                Show();
        }

        /// <summary>Draws the wake of the phase that is drawn.</summary>
        public void Draw(InsectWings insect, IGizmoPen pen)
        {
            if (m_Shown == null || insect.Live.wings.Length != m_Shown[0].Length)
                return;
            double beat = BeatOf(insect);
            Sheet[] sheets = m_Shown[(int)((beat - math.floor(beat)) * k_Steps) % k_Steps];
            Transform body = insect.transform;
            foreach (Sheet sheet in sheets)
            {
                for (int k = 0; k < sheet.points.Length; k++)
                {
                    Vector3 at = World(body, sheet.points[k]);
                    if (k % sheet.width + 1 < sheet.width)
                        pen.Line(at, World(body, sheet.points[k + 1]), Colour(sheet, k), false);
                    if (k + sheet.width < sheet.points.Length)
                        pen.Line(at, World(body, sheet.points[k + sheet.width]), Colour(sheet, k), false);
                }
            }
        }

        private static double BeatOf(InsectWings insect)
        {
            WingReading first = insect.Read(0);
            return first.Beats + first.Phase / (2.0 * math.PI_DBL);
        }

        private static float3 InBody(Transform body, Vector3 place) => Quaternion.Inverse(body.rotation) * (place - body.position);

        private Vector3 World(Transform body, float3 place) => body.position + body.rotation * (Vector3)(m_ShownLength * place);

        private Color Colour(Sheet sheet, int point)
        {
            float share = sheet.circulation[point] / m_Strongest;
            Color colour = share < 0f ? GizmoColours.WakeDown : GizmoColours.WakeUp;
            colour.a = Mathf.Lerp(k_Faintest, k_Densest, Mathf.Abs(share));
            return colour;
        }

        // Joints in lengths of the scene, axes of the body.
        private void Gather(InsectWings insect)
        {
            if (m_Traces.Count != insect.Live.wings.Length)
            {
                Dispose();
                m_Traces.Clear();
                for (int wing = 0; wing < insect.Live.wings.Length; wing++)
                    m_Traces.Add(new JointTrace());
            }

            double beat = BeatOf(insect);
            for (int wing = 0; wing < m_Traces.Count; wing++)
            {
                var sketch = ChainSketch.Of(insect, wing);
                if (sketch == null)
                    continue;
                var joints = new float3[sketch.ChainCount * sketch.JointsPerChain];
                for (int k = 0; k < joints.Length; k++)
                    joints[k] = InBody(insect.transform, sketch.Joint(k / sketch.JointsPerChain, k % sketch.JointsPerChain));
                m_Traces[wing].Add(beat, joints);
            }
        }

        private void Begin(InsectWings insect)
        {
            m_Length = 0f;
            foreach (LiveWing wing in insect.Live.wings)
                m_Length = Mathf.Max(m_Length, wing.placed.length);
            var wings = new List<WakeWing>();
            BodyFlight flight = insect.Live.flight;
            try
            {
                for (int wing = 0; wing < m_Traces.Count; wing++)
                {
                    if (!m_Traces[wing].TrySample(k_Steps, out float3[][] beat))
                        return;
                    WingReading reading = insect.Read(wing);
                    foreach (float3[] joints in beat)
                    {
                        for (int k = 0; k < joints.Length; k++)
                            joints[k] /= m_Length;
                    }

                    wings.Add(new WakeWing(
                        FourierMotion.Through(beat, reading.ChainCount, reading.JointsPerChain),
                        insect.Live.wings[wing].values.parameters.options));
                }

                m_Wake = new FreeWake(
                    new WakeSettings
                    {
                        SpanPanels = k_Strips,
                        StepsPerBeat = k_Steps,
                        Keep = k_Keep,
                        FarCore = k_FarCore,
                        Stream = InBody(insect.transform, insect.transform.position + (Vector3)(flight.wind - flight.velocity))
                            / (m_Length * math.max(insect.Frequency, 1e-3f)),
                    }, wings);
            }
            catch (ArgumentException)
            {
                // Wings that are folded up have no area, and what flies beyond all bounds no wake; the next frames may.
                return;
            }

            m_Next = new Sheet[k_Steps][];
        }

        private void Show()
        {
            m_Wake.Dispose();
            m_Wake = null;
            m_Shown = m_Next;
            m_ShownLength = m_Length;
            m_Strongest = 1e-12f;
            foreach (Sheet[] sheets in m_Shown)
            {
                foreach (Sheet sheet in sheets)
                {
                    foreach (float circulation in sheet.circulation)
                        m_Strongest = Mathf.Max(m_Strongest, Mathf.Abs(circulation));
                }
            }
        }

        private Sheet[] Copy()
        {
            var sheets = new Sheet[m_Wake.WingCount];
            for (int wing = 0; wing < sheets.Length; wing++)
                sheets[wing] = new Sheet(m_Wake.Sheet(wing));
            return sheets;
        }

        /// <summary>Wake of a wing at a phase, wing lengths, axes of the body.</summary>
        private readonly struct Sheet
        {
            public readonly int width;
            public readonly float3[] points;

            /// <summary>[point] Of the ring behind it; none behind the last row and beside the last point.</summary>
            public readonly float[] circulation;

            public Sheet(WakeSheet sheet)
            {
                width = sheet.PointsPerRow;
                points = new float3[sheet.RowCount * width];
                circulation = new float[points.Length];
                for (int k = 0; k < points.Length; k++)
                {
                    points[k] = sheet.Point(k / width, k % width);
                    if (k / width + 1 < sheet.RowCount)
                        circulation[k] = sheet.Circulation(k / width, math.min(k % width, width - 2));
                }
            }
        }
    }
}
