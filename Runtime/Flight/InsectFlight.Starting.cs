using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Start and end of a flight.</summary>
    public sealed partial class InsectFlight
    {
        /// <summary>
        /// Fastest motion and turning of a body that is not lost, m/s and rad/s: what the bounds of the air and of bodies allow, and as
        /// much again.
        /// </summary>
        private const float k_Fastest = 2f * OuterBounds.Speed, k_MostSpin = 2f * OuterBounds.Turning;

        private Start m_Start;
        private int m_Presets;
        private Vector3 m_Home;
        private bool m_IsLossTold;

        // A start that failed is tried again when something has changed, not in every step.
        private bool IsAttached(LiveInsect live, WingWorld world)
        {
            var start = new Start(live, world, m_Trims);
            bool flies = m_World != null;
            int presets = flies ? 0 : PresetsOf(live);
            if (start.Is(m_Start) && (flies || presets == m_Presets))
                return flies;
            m_Start = start;
            m_Presets = presets;
            return Attach(live, world);
        }

        private static int PresetsOf(LiveInsect live)
        {
            int presets = 0;
            foreach (LiveWing wing in live.wings)
                presets = HashCode.Combine(presets, wing.values, wing.values.Stamp);
            return presets;
        }

        private bool Attach(LiveInsect live, WingWorld world)
        {
            bool again = !m_StartsOver && ReferenceEquals(live, m_Live) && ReferenceEquals(world, m_World) && world.Contains(m_Body);
            FlyingBody kept = again ? world.Body(m_Body) : default;
            Vector3 from = m_From;
            Detach();
            m_StartsOver = false;
            if (!Measure(live))
                return false;
            m_World = world;
            m_Live = live;
            if (live.Clock == WingUpdateMode.FixedUpdate && TryGetComponent(out Rigidbody rigid))
                m_Carried = new CarriedRigidbody(rigid);
            Problem = FlightProblem.None;
            FlyingBody body = m_Model.CreateBody();
            body.table = m_Table.View;
            body.steered = 1;
            body.mode = BodyMode.Free;
            if (again)
            {
                body.rotation = kept.rotation;
                body.velocity = kept.velocity;
                body.spin = kept.spin;
                body.reference = kept.reference;
                body.mode = kept.mode;
                body.position = kept.position;
            }
            else
            {
                float heading = Headings.Of(transform.rotation);
                m_Reference = new FlightReference(default, heading, default);
                body.reference.heading = heading;
                State = FlightState.Flying;
                m_Perching = default;
                m_Home = transform.position;
            }

            m_Body = world.AddBody(body);
            for (int k = 0; k < live.wings.Length; k++)
                world.Attach(live.wings[k].handle, m_Body, m_Model.Place(m_Model.Wings[k]));
            if (again)
            {
                m_From = from;
                return true;
            }

            StartBeat(live, world, body.reference);
            if (IsRecording)
                m_Recorder.Begin(m_Model, new FlightStart { heading = body.reference.heading, phase = live.insect.StartPhase });
            ref FlyingBody placed = ref world.Body(m_Body);
            m_FromRotation = placed.rotation;
            m_From = transform.position + (Vector3)math.rotate(transform.rotation, m_Model.Centre * m_Units);
            Show(placed.rotation, m_From);
            return true;
        }

        private bool IsLost(in FlyingBody body)
        {
            bool moves = OuterBounds.Hold(body.velocity, k_Fastest) && OuterBounds.Hold(body.spin, k_MostSpin);
            bool isSomewhere = OuterBounds.Hold(body.position * m_Units + (float3)m_From, OuterBounds.Distance);
            return !moves || !isSomewhere || !(math.abs(math.lengthsq(body.rotation.value) - 1f) < 0.1f);
        }

        // What the steps made of the body is gone: it hovers where it was last, or where it began if that is nowhere either.
        private bool StartAgain(LiveInsect live, WingWorld world)
        {
            bool isKnown = OuterBounds.Hold(m_ShownPosition, OuterBounds.Distance) && OuterBounds.Hold(m_From, OuterBounds.Distance);
            Vector3 place = isKnown ? m_ShownPosition : OuterBounds.Hold(m_Home, OuterBounds.Distance) ? m_Home : Vector3.zero;
            float heading = Headings.Of(m_ShownRotation);
            if (!m_IsLossTold)
                Debug.LogWarning($"'{name}' was lost: its motion was no number, or beyond any insect's. It starts again at {place}.", this);
            m_IsLossTold = true;
            m_Carried?.Place(place, Quaternion.identity);
            Detach();
            transform.SetPositionAndRotation(place, Rotations.AboutY(math.isfinite(heading) ? heading : 0f));
            foreach (LiveWing wing in live.wings)
                wing.Place();
            return Attach(live, world);
        }

        private void StartBeat(LiveInsect live, WingWorld world, in BodyReference reference)
        {
            WingDrive drive = m_Table.DriveNear(reference.airSpeed, reference.climb);
            foreach (LiveWing wing in live.wings)
            {
                world.SetDrive(wing.handle, drive);
                world.Reset(wing.handle);
                world.Resume(wing.handle, live.insect.StartPhase / (360f * drive.frequency));
            }

            world.PlaceOnBob(m_Body);
        }

        private bool Measure(LiveInsect live)
        {
            if (m_Trims == null)
            {
                Fail(FlightProblem.NoTrims, "it has no trims. Bake them, or take an insect of the catalogue.");
                return false;
            }

            m_Units = SceneModel.UnitsPerMetre(live.wings[0].placed, live.wings[0].values);
            try
            {
                m_Model = new FlightModel(WingsOf(live), m_Parts, live.wings[0].values.size.insectMass,
                    live.wings[0].values.size.fluidDensity, live.wings[0].values.size.gravityShare);
            }
            catch (ArgumentException problem)
            {
                Fail(FlightProblem.BadBody, problem.Message);
                return false;
            }

            m_Table = m_Trims.Open(m_Model.Key);
            if (m_Table != null)
            {
                m_Table.Acceleration = m_Model.AccelerationAt(m_Table.TopSpeed);
                Limits = m_Table.Limits;
                return true;
            }

            m_Model.Dispose();
            m_Model = null;
            Fail(FlightProblem.OtherNumbers,
                "its trims were made for other numbers of preset or body. Take the preset of the variant Flight, or bake trims.");
            return false;
        }

        private List<FlightWing> WingsOf(LiveInsect live)
        {
            var wings = new List<FlightWing>();
            foreach (LiveWing wing in live.wings)
                wings.Add(SceneModel.Describe(wing.rig, wing.placed, live.root.rotation, live.root.position, wing.values, m_Units));
            return wings;
        }

        private void Detach()
        {
            if (m_Recorder != null && m_Recorder.HasBegun)
                m_Recorder.End("the flight has ended or started again");
            // First, for it ends the step that may still read the table.
            if (m_World != null && ReferenceEquals(WingSystem.Loop?.World, m_World))
            {
                m_World.RemoveBody(m_Body);
                for (int k = 0; m_Live != null && k < m_Live.wings.Length; k++)
                {
                    if (m_World.Contains(m_Live.wings[k].handle))
                        m_World.ReleaseDrive(m_Live.wings[k].handle);
                    m_Live.wings[k].ForgetFold();
                }
            }

            if (m_Table != null)
                FlightTrims.Return(m_Table);
            m_Table = null;
            m_Model?.Dispose();
            m_Model = null;
            m_Carried?.Release();
            m_Carried = null;
            m_World = null;
            m_Live = null;
        }

        /// <summary>Inputs that a flight was started with; a change of one starts the flight again.</summary>
        private readonly struct Start
        {
            private readonly LiveInsect m_Live;
            private readonly WingWorld m_World;
            private readonly WingHandle m_First;
            private readonly FlightTrims m_Trims;

            public Start(LiveInsect live, WingWorld world, FlightTrims trims)
            {
                m_Live = live;
                m_World = world;
                m_First = live.wings[0].handle;
                m_Trims = trims;
            }

            public bool Is(in Start other) =>
                ReferenceEquals(m_Live, other.m_Live) && ReferenceEquals(m_World, other.m_World) && m_First.Equals(other.m_First)
                && ReferenceEquals(m_Trims, other.m_Trims);
        }
    }
}
