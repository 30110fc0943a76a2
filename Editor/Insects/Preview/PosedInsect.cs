using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Insect in edit mode as it beats on the spot, by the values that its fields have now. Each pose is computed from rest in a world
    /// of its own, so that it depends on these values alone. Writes nothing that is saved. Dispose it.
    /// </summary>
    internal sealed class PosedInsect : IDisposable
    {
        /// <summary>Beats from rest until a pose counts as settled; folded wings have come to rest by then.</summary>
        public const int SettleBeats = 5;

        private const float k_TwoPi = 2f * math.PI, k_PhaseTolerance = 1e-4f;

        private readonly InsectWings m_Insect;
        private readonly CrowdCameras m_Cameras;
        private readonly List<PosedMesh> m_Meshes = new List<PosedMesh>();
        private int m_Built;
        private Shape m_Shown;

        /// <param name="insect">In an open scene or stage.</param>
        public PosedInsect(InsectWings insect)
        {
            m_Insect = insect;
            m_Cameras = new CrowdCameras(insect.gameObject, Draw);
        }

        /// <summary>True while the insect is there and asks for it.</summary>
        public bool IsWanted => m_Insect != null && m_Insect.Preview.shows;

        /// <summary>Posed meshes; none where the insect is off or has a problem.</summary>
        public IReadOnlyList<PosedMesh> Meshes => m_Meshes;

        /// <summary>Number of poses that were computed.</summary>
        public int PoseCount { get; private set; }

        /// <summary>Takes over what has changed.</summary>
        public void Refresh()
        {
            if (!IsWanted || !m_Insect.isActiveAndEnabled || m_Insect.FindProblem().IsProblem)
            {
                Clear();
                return;
            }

            int content = ContentOf(m_Insect);
            if (content != m_Built)
            {
                Clear();
                m_Built = content;
                Build();
            }

            if (m_Meshes.Count == 0)
                return;
            Shape shape = Now();
            if (m_Shown != null && shape.Is(m_Shown))
                return;
            m_Shown = shape;
            Show(shape);
        }

        public void Dispose()
        {
            m_Cameras.Dispose();
            Clear();
        }

        private void Draw(Camera camera)
        {
            Refresh();
            foreach (PosedMesh mesh in m_Meshes)
                mesh.Draw(camera);
        }

        private void Clear()
        {
            foreach (PosedMesh mesh in m_Meshes)
                mesh.Dispose();
            m_Meshes.Clear();
            m_Shown = null;
            m_Built = 0;
        }

        private static int ContentOf(InsectWings insect)
        {
            var content = new HashCode();
            content.Add(insect.Patches);
            foreach (Wing wing in insect.Wings)
            {
                content.Add(wing.Renderer);
                content.Add(InsectCheck.FilterOf(wing).sharedMesh);
                content.Add(wing.Part);
                content.Add(wing.Submesh);
                content.Add(wing.Point);
                content.Add(wing.Skeleton == null ? 0 : new SkeletonValue(wing.Skeleton).Hash);
            }

            return content.ToHashCode();
        }

        private void Build()
        {
            List<Wing> wings = m_Insect.Wings;
            foreach (IGrouping<MeshRenderer, int> group in Enumerable.Range(0, wings.Count).GroupBy(w => wings[w].Renderer))
            {
                var places = group.ToList();
                Mesh mesh = InsectCheck.FilterOf(wings[places[0]]).sharedMesh;
                var automatic = new AutomaticSkeleton(m_Insect.transform, group.Key.transform);
                RiggedPart[] parts = new RiggedParts(mesh, automatic, m_Insect.Patches)
                    .Build(places.ConvertAll(w => wings[w]).ToArray(), places, out _);
                if (parts == null)
                {
                    // The inspector says why; the authored meshes are shown until something changes.
                    int built = m_Built;
                    Clear();
                    m_Built = built;
                    return;
                }

                m_Meshes.Add(new PosedMesh(group.Key, mesh, places.ToArray(), parts));
            }
        }

        private Shape Now()
        {
            var shape = new Shape(m_Insect);
            var tuning = new InsectTuning(m_Insect, 1f);
            shape.fold = tuning.Fold;
            var flight = new BodyFlight
            {
                position = m_Insect.transform.position,
                forward = m_Insect.transform.forward,
                gravity = Physics.gravity,
                wind = m_Insect.Air.wind,
                metresPerUnit = m_Insect.MotionSettings.metresPerUnit,
            };
            foreach (PosedMesh mesh in m_Meshes)
            {
                for (int part = 0; part < mesh.Parts.Length; part++)
                {
                    Wing wing = m_Insect.Wings[mesh.Wings[part]];
                    var values = new PresetValues(wing.Preset == null ? m_Insect.Preset : wing.Preset);
                    var placed = new PlacedWing(wing.Renderer.transform.localToWorldMatrix, mesh.Parts[part].Rig.Frame);
                    WingSurroundings around = placed.isValid
                        ? flight.Around(placed, values.size.wingLength, values.size.gravityShare) : default;
                    shape.values.Add(values);
                    shape.parameters.Add(tuning.ParametersOf(values, wing));
                    shape.surroundings.Add(around.IsFinite && OuterBounds.Hold(flight.wind, OuterBounds.Distance) ? around : default);
                }
            }

            return shape;
        }

        private void Show(Shape shape)
        {
            PoseCount++;
            using var world = new WingWorld();
            var handles = new List<WingHandle>();
            foreach (RiggedPart part in m_Meshes.SelectMany(mesh => mesh.Parts))
            {
                int wing = handles.Count;
                handles.Add(world.Add(part.Rig, shape.parameters[wing], shape.surroundings[wing]));
                if (shape.fold > 0f)
                    world.SetDrive(handles[wing], shape.values[wing].Folded(shape.fold));
            }

            for (int beat = 0; beat < SettleBeats; beat++)
                world.Step(1f / world.Read(handles[0]).Frequency);
            for (int tries = 0; tries < 3; tries++)
            {
                WingReading reading = world.Read(handles[0]);
                float ahead = math.frac(shape.phase - reading.Phase / k_TwoPi);
                if (ahead < k_PhaseTolerance || ahead > 1f - k_PhaseTolerance)
                    break;
                world.Step(ahead / reading.Frequency);
            }

            world.Skin();
            int next = 0;
            foreach (PosedMesh mesh in m_Meshes)
            {
                for (int part = 0; part < mesh.Parts.Length; part++)
                    mesh.Take(part, world.Vertices(handles[next++]));
                mesh.Apply();
            }
        }

        /// <summary>All that a pose depends on.</summary>
        private sealed class Shape
        {
            public readonly float phase;
            public readonly List<PresetValues> values = new List<PresetValues>();
            public readonly List<WingParameters> parameters = new List<WingParameters>();
            public readonly List<WingSurroundings> surroundings = new List<WingSurroundings>();
            public float fold;

            public Shape(InsectWings insect)
            {
                float beat = insect.Preview.beat, start = NumberRange.Clamp(insect.StartPhase, 0f, 360f, 0f) / 360f;
                phase = math.frac((math.isfinite(beat) ? math.frac(beat) : 0f) + start);
            }

            public bool Is(Shape other)
            {
                if (phase != other.phase || fold != other.fold || parameters.Count != other.parameters.Count)
                    return false;
                for (int wing = 0; wing < parameters.Count; wing++)
                {
                    if (!parameters[wing].SameAs(other.parameters[wing]) || !surroundings[wing].Equals(other.surroundings[wing]))
                        return false;
                    if (fold > 0f && !values[wing].Folded(fold).Equals(other.values[wing].Folded(fold)))
                        return false;
                }

                return true;
            }
        }
    }
}
