using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>
    /// The wings of one insect in steady flight, from which a loop is recorded. Frames are flown twice as finely as they are kept: every
    /// other one tells the error between them.
    /// </summary>
    internal sealed class BakeFlight : IDisposable
    {
        /// <summary>
        /// Shares of the wing length: a beat that differs less from the one before has settled; a loop that closes worse is none; less
        /// motion is none.
        /// </summary>
        private const float k_Settled = 2e-4f, k_Closed = 0.02f, k_Still = 1e-3f;

        private const int k_LeastBeats = 6, k_MostBeats = 60, k_Fineness = 2;

        private readonly WingWorld m_World = new WingWorld();
        private readonly List<WingHandle> m_Handles = new List<WingHandle>();
        private readonly IReadOnlyList<DrawnWing> m_Drawn;
        private readonly IReadOnlyList<BakedWing> m_Wings;
        private readonly BakedSurface m_Surface;
        private readonly IReadOnlyList<DrawnAbdomen> m_Abdomens;
        private readonly WingParameters m_First;
        private readonly BakeMotion m_Motion;
        private readonly float m_MaxSpeed;
        private readonly SteadyFlight m_Steady;
        private readonly BodyFlight m_Flight;

        /// <exception cref="BakeException">Parameters out of range, or wings that beat at different rates.</exception>
        public BakeFlight(
            InsectWings insect, DrawnInsect drawn, IReadOnlyList<BakedWing> wings, BakedSurface surface, BakeMotion motion,
            SteadyFlight steady,
            float metresPerUnit)
        {
            m_Drawn = drawn.Wings;
            m_Abdomens = drawn.Abdomens;
            m_Wings = wings;
            m_Surface = surface;
            m_Motion = motion;
            m_First = ValuesOf(insect, m_Drawn[0]).parameters;
            m_MaxSpeed = new PresetValues(insect.Preset).parameters.maxSpeed;
            m_Steady = steady;
            float told = insect.MotionSettings.metresPerUnit;
            m_Flight = steady == null ? motion.FlightOf(m_MaxSpeed, told, metresPerUnit) : steady.FlightOf(told, metresPerUnit);
            try
            {
                foreach (DrawnWing wing in m_Drawn)
                    m_Handles.Add(Add(insect, wing));
                CheckFrequencies();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Hertz.</summary>
        private float Frequency => m_World.Read(m_Handles[0]).Frequency;

        /// <summary>Records one loop.</summary>
        /// <param name="settings">How finely.</param>
        /// <param name="report">Gets the share that is done, 0 to 1, once a beat; what it throws ends the recording.</param>
        /// <exception cref="BakeException">No beat is like the one before.</exception>
        public BakedClip Record(in BakeSettings settings, Action<float> report = null)
        {
            int frames = settings.Frames, steps = k_Fineness * frames;
            var flown = new BakedFrame[steps + 1];
            flown[0] = Settle(steps, report);
            for (int step = 1; step <= steps; step++)
            {
                Advance(steps);
                flown[step] = Capture();
            }

            float closure = Distance(flown[0], flown[steps]);
            if (!(closure < k_Closed))
            {
                throw new BakeException(
                    $"Clip '{m_Motion.Name}' does not loop: after {k_MostBeats} beats the wings are {100f * closure:0.#} % of their length "
                    + $"from where they were one beat before; at most {100f * k_Closed:0} % are closed.");
            }

            Close(flown);
            BakeError error = LinearSkin(flown, k_Fineness);
            error.closure = closure;
            BakedFrame[] kept = IsStill(flown) ? new[] { flown[0] } : Every(flown, k_Fineness, frames);
            MeasureBetween(flown, kept, ref error);
            return new BakedClip
            {
                Motion = m_Motion,
                Frequency = Frequency,
                Velocity = m_Flight.velocity,
                AngularVelocity = m_Flight.angularVelocity,
                Attitude = m_Steady == null ? Rotations.AboutX(-math.radians(m_Motion.PitchDegrees)) : m_Steady.Attitude,
                RightBeat = m_Steady?.Right,
                LeftBeat = m_Steady?.Left,
                Frames = kept,
                Error = error,
            };
        }

        /// <summary>Frees the world.</summary>
        public void Dispose() => m_World.Dispose();

        private static PresetValues ValuesOf(InsectWings insect, DrawnWing wing) =>
            new PresetValues(wing.Wing.Preset == null ? insect.Preset : wing.Wing.Preset);

        private WingHandle Add(InsectWings insect, DrawnWing wing)
        {
            PresetValues values = ValuesOf(insect, wing);
            WingParameters parameters = values.parameters;
            parameters.amplitudeScale *= wing.Wing.AmplitudeScale;
            parameters.phaseLead += Mathf.Deg2Rad * wing.Wing.PhaseLead;
            WingSurroundings around = m_Flight.Around(wing.Placed, values.size.wingLength, values.size.gravityShare);
            if (m_Steady != null)
            {
                WingHandle driven = m_World.Add(wing.Rig, parameters.Clamped(), around);
                m_World.SetDrive(driven, wing.Wing.Side == WingSide.Left ? m_Steady.Left : m_Steady.Right);
                m_World.Reset(driven);
                return driven;
            }

            // One body has one speed, also where its wings are drawn at slightly different scales.
            around.speed = m_Motion.SpeedOf(m_MaxSpeed);
            m_Motion.Apply(wing.Wing.Side, ref parameters);
            WingHandle added = m_World.Add(wing.Rig, parameters.Clamped(), around);
            float fold = m_Motion.Steering.Clamped().fold;
            if (fold > 0f)
            {
                m_World.SetDrive(added, values.Folded(fold));
                m_World.Reset(added);
            }

            return added;
        }

        private void CheckFrequencies()
        {
            for (int wing = 1; wing < m_Handles.Count; wing++)
            {
                float frequency = m_World.Read(m_Handles[wing]).Frequency;
                if (math.abs(frequency / Frequency - 1f) > 1e-4f)
                {
                    throw new BakeException(
                        $"Clip '{m_Motion.Name}' does not loop: '{m_Wings[wing].Name}' beats at "
                        + $"{frequency:0.##} Hz, '{m_Wings[0].Name}' at {Frequency:0.##} Hz; all wings must beat at one rate.");
                }
            }
        }

        // Whole beats, in as many steps each as the recorded one.
        private BakedFrame Settle(int steps, Action<float> report)
        {
            BakedFrame before = null;
            for (int beat = 1; ; beat++)
            {
                // Most wings settle long before the last beat that they may have.
                report?.Invoke(1f - (float)k_LeastBeats / (k_LeastBeats + beat));
                for (int step = 0; step < steps; step++)
                    Advance(steps);
                BakedFrame now = Capture();
                if (beat >= k_MostBeats || (beat >= k_LeastBeats && Distance(before, now) < k_Settled))
                    return now;
                before = now;
            }
        }

        private void Advance(int steps) => m_World.Step((float)(1.0 / ((double)Frequency * steps)));

        private BakedFrame Capture()
        {
            var frame = new BakedFrame(m_Surface.VertexCount, WingJoints + m_Abdomens.Count);
            for (int vertex = 0; vertex < frame.Positions.Length; vertex++)
            {
                frame.Positions[vertex] = m_Surface.Positions[vertex];
                frame.Normals[vertex] = m_Surface.Normals[vertex];
            }

            WingReading first = m_World.Read(m_Handles[0]);
            for (int k = 0; k < m_Abdomens.Count; k++)
                m_Abdomens[k].Pose(frame, WingJoints + k, first.Phase, BeatingShare.Of(first.Amplitude.x, m_First));
            m_World.Skin();
            for (int w = 0; w < m_Handles.Count; w++)
            {
                DrawnWing drawn = m_Drawn[w];
                int[] targets = m_Wings[w].Vertices;
                NativeArray<SkinnedVertex> skinned = m_World.Vertices(m_Handles[w]);
                for (int k = 0; k < targets.Length; k++)
                {
                    frame.Positions[targets[k]] = drawn.ToInsect.MultiplyPoint3x4(skinned[k].position);
                    frame.Normals[targets[k]] = drawn.Normals.Apply(skinned[k].normal);
                }

                drawn.Write(m_World.Read(m_Handles[w]), m_Wings[w], frame);
            }

            return frame;
        }

        private int WingJoints
        {
            get
            {
                BakedWing last = m_Wings[m_Wings.Count - 1];
                return last.FirstJoint + last.RestJoints.Length;
            }
        }

        // What the end differs from the start by is taken back evenly over the loop.
        private static void Close(BakedFrame[] flown)
        {
            int steps = flown.Length - 1;
            for (int step = 1; step < steps; step++)
            {
                float share = (float)step / steps;
                for (int vertex = 0; vertex < flown[0].Positions.Length; vertex++)
                    flown[step].Positions[vertex] -= share * (flown[steps].Positions[vertex] - flown[0].Positions[vertex]);
            }
        }

        private static BakedFrame[] Every(BakedFrame[] flown, int stride, int count)
        {
            var kept = new BakedFrame[count];
            for (int frame = 0; frame < count; frame++)
                kept[frame] = flown[frame * stride];
            return kept;
        }

        private bool IsStill(BakedFrame[] flown) => Array.TrueForAll(flown, frame => Distance(flown[0], frame) < k_Still);

        // Largest distance of a vertex of a wing, wing lengths.
        private float Distance(BakedFrame a, BakedFrame b)
        {
            float largest = 0f;
            foreach (BakedWing wing in m_Wings)
            {
                foreach (int vertex in wing.Vertices)
                    largest = math.max(largest, math.distance(a.Positions[vertex], b.Positions[vertex]) / wing.Length);
            }

            return largest;
        }

        private void MeasureBetween(BakedFrame[] flown, BakedFrame[] kept, ref BakeError error)
        {
            foreach (BakedWing wing in m_Wings)
            {
                for (int step = 1; step < flown.Length; step += k_Fineness)
                {
                    int before = step / k_Fineness % kept.Length;
                    BakedFrame from = kept[before], to = kept[(before + 1) % kept.Length];
                    foreach (int vertex in wing.Vertices)
                    {
                        float3 blended = math.lerp(from.Positions[vertex], to.Positions[vertex], 0.5f);
                        error.between = math.max(error.between, math.distance(blended, flown[step].Positions[vertex]) / wing.Length);
                        float3 normal = math.normalizesafe(from.Normals[vertex] + to.Normals[vertex]);
                        float cosine = math.clamp(math.dot(normal, flown[step].Normals[vertex]), -1f, 1f);
                        error.normalBetween = math.max(error.normalBetween, math.degrees(Elementary.Acos(cosine)));
                    }
                }
            }
        }

        private BakeError LinearSkin(BakedFrame[] flown, int stride)
        {
            var error = new BakeError();
            foreach (BakedWing wing in m_Wings)
            {
                for (int step = 0; step < flown.Length - 1; step += stride)
                {
                    for (int k = 0; k < wing.Vertices.Length; k++)
                    {
                        float3 rest = m_Surface.Positions[wing.Vertices[k]], skinned = 0f;
                        for (int c = 0; c < 4; c++)
                        {
                            int joint = wing.VertexJoints[k][c];
                            BakedJoint pose = flown[step].Joints[wing.FirstJoint + joint];
                            skinned +=
                                wing.VertexWeights[k][c] * (pose.position + math.rotate(pose.rotation, rest - wing.RestJoints[joint]));
                        }

                        error.linearSkin = math.max(
                            error.linearSkin, math.distance(skinned, flown[step].Positions[wing.Vertices[k]]) / wing.Length);
                    }
                }
            }

            return error;
        }
    }
}
