using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>The flight while it lives: its body in the world of the wings.</summary>
    public sealed partial class InsectFlight
    {
        private InsectWings m_Wings;
        private Link m_Link;
        private WingWorld m_World;
        private LiveInsect m_Live;
        private BodyHandle m_Body;
        private WingHandle m_First;
        private FlightModel m_Model;
        private TrimTable m_Table;
        private FlightReference m_Reference;
        private Perching m_Perching;
        private double m_Time;
        private float m_Units;
        private Vector3 m_ShownPosition;
        private Quaternion m_ShownRotation, m_FromRotation;
        private Vector3 m_From;

        private void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float dt)
        {
            if ((!ReferenceEquals(live, m_Live) || !ReferenceEquals(world, m_World) || !m_First.Equals(live.wings[0].handle)) && !Attach(live, world))
                return;
            PlacedWing placed = live.wings[0].placed;
            if (!placed.isValid)
                return;
            m_Units = live.insect.MotionSettings.metresPerUnit > 0f ? 1f / live.insect.MotionSettings.metresPerUnit : placed.length / live.wings[0].values.size.wingLength;
            ref FlyingBody body = ref world.Body(m_Body);
            TakeOver(ref body);
            body.wind = wind / m_Units;
            body.weight = gravity * m_Model.GravityShare;
            body.gravity = gravity;
            body.aid = m_Aid;
            Fly(ref body, dt);
            m_Time += dt;
        }

        // Between steps: where the body has got to becomes where the next step starts; whoever moved the object meanwhile has moved the body.
        private void TakeOver(ref FlyingBody body)
        {
            var moved = (Vector3)(body.position * m_Units);
            m_From += moved;
            body.position = body.positionRest = default;
            if (transform.position != m_ShownPosition || transform.rotation != m_ShownRotation)
                Teleported(ref body);
            m_FromRotation = body.rotation;
            Position = m_From;
            BodyVelocity = body.velocity;
            AidPower = body.aidPower;
        }

        private void Teleported(ref FlyingBody body)
        {
            // The turn about the vertical is taken over; pitch and roll are the flight's own.
            float turn = HeadingOf(transform.rotation) - HeadingOf(m_ShownRotation);
            if (math.abs(turn) > 1e-3f)
            {
                var turned = quaternion.AxisAngle(new float3(0f, 1f, 0f), turn);
                body.rotation = math.mul(turned, body.rotation);
                body.velocity = math.rotate(turned, body.velocity);
                m_Reference = m_Reference.Turned(turn);
            }

            m_From = transform.position + (Vector3)math.rotate(transform.rotation, m_Model.Centre * m_Units);
            Show(body.rotation, m_From);
        }

        private void Fly(ref FlyingBody body, float dt)
        {
            FlightSituation situation = Situation(body, dt);
            FlightCommand command = Command(situation);
            if (State == FlightState.Perched)
            {
                if (command.wish == FlightWish.Perch)
                    m_Perching.Sit(ref body, dt);
                else if (m_Perching.Start(ref body, m_World, m_Body, m_Table.DriveNear(0f, 0f), m_Live, dt))
                    TakeOff(ref body);
                m_From = m_Perching.Centre(body.rotation, Legs);
                Show(body.rotation, m_From);
                if (State == FlightState.Perched)
                    return;
            }
            else if (command.wish == FlightWish.Perch)
            {
                Perch(ref body, command.spot);
                return;
            }

            body.reference = m_Reference.Step(command.velocity, command.heading, body.wind, m_Table, dt);
            State = body.Tumbles ? FlightState.Tumbling : command.wish == FlightWish.Land ? FlightState.Landing : FlightState.Flying;
        }

        private FlightCommand Command(in FlightSituation situation)
        {
            if (m_Pilot == null || m_Pilot is UnityEngine.Object gone && gone == null)
                m_Pilot = TryGetComponent(out FlightPilot found) && found.isActiveAndEnabled ? found : null;
            return m_Pilot?.Command(situation) ?? FlightCommand.Fly(Velocity, Heading);
        }

        private FlightSituation Situation(in FlyingBody body, float dt) => new FlightSituation(body, m_Reference)
        {
            position = m_From,
            state = State,
            limits = Limits,
            time = m_Time,
            deltaTime = dt,
            wingLength = m_Model.Length,
            unitsPerMetre = m_Units,
        };

        private float3 Legs => ((float3)m_Live.wings[0].values.Feet - m_Model.Centre) * m_Units;

        private void Perch(ref FlyingBody body, in PerchSpot spot)
        {
            m_Perching = new Perching(ref body, spot, m_From, Legs);
            m_FromRotation = body.rotation;
            foreach (LiveWing wing in m_Live.wings)
                m_World.SetDrive(wing.handle, new WingDrive { frequency = m_Model.Frequency, amplitude = 0f });
            State = FlightState.Perched;
            Show(body.rotation, m_From);
            Landed?.Invoke(this);
        }

        private void TakeOff(ref FlyingBody body)
        {
            float heading = HeadingOf(body.rotation);
            m_Reference = new FlightReference(default, heading, body.wind);
            body.reference = new BodyReference { heading = heading };
            body.mode = BodyMode.Free;
            body.integral = default;
            body.latched = 0;
            m_World.PlaceOnBob(m_Body);
            m_FromRotation = body.rotation;
            State = FlightState.Flying;
            TookOff?.Invoke(this);
        }

        private bool Attach(LiveInsect live, WingWorld world)
        {
            bool again = m_Model != null && ReferenceEquals(live, m_Live) && ReferenceEquals(world, m_World) && world.Contains(m_Body);
            FlyingBody kept = again ? world.Body(m_Body) : default;
            Vector3 from = m_From;
            Detach();
            if (!Measure(live))
                return false;
            m_World = world;
            m_Live = live;
            m_First = live.wings[0].handle;
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
                float heading = HeadingOf(transform.rotation);
                m_Reference = new FlightReference(default, heading, default);
                body.reference.heading = heading;
                State = FlightState.Flying;
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
            ref FlyingBody placed = ref world.Body(m_Body);
            m_FromRotation = placed.rotation;
            m_From = transform.position + (Vector3)math.rotate(transform.rotation, m_Model.Centre * m_Units);
            Show(placed.rotation, m_From);
            Problem = FlightProblem.None;
            return true;
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
                Fail(FlightProblem.NoTrims, "it has no trims. Make them by TrimBake, or take an insect of the catalogue.");
                return false;
            }

            PlacedWing first = live.wings[0].placed;
            m_Units = first.isValid ? first.length / live.wings[0].values.size.wingLength : 1f;
            try
            {
                m_Model = new FlightModel(WingsOf(live), m_Parts, live.wings[0].values.size.insectMass, live.wings[0].values.size.fluidDensity, live.wings[0].values.size.gravityShare);
            }
            catch (ArgumentException problem)
            {
                Fail(FlightProblem.BadBody, problem.Message);
                return false;
            }

            m_Table = m_Trims.Take(m_Model.Key);
            if (m_Table != null)
            {
                Limits = m_Table.Limits;
                return true;
            }

            m_Model.Dispose();
            m_Model = null;
            Fail(FlightProblem.NoTrims, "its trims were made for other numbers of preset or body.");
            return false;
        }

        private List<FlightWing> WingsOf(LiveInsect live)
        {
            var wings = new List<FlightWing>();
            quaternion back = math.conjugate((quaternion)live.root.rotation);
            foreach (LiveWing wing in live.wings)
            {
                PlacedWing placed = wing.placed;
                var axes = new float3x3(math.rotate(back, placed.span), math.rotate(back, placed.up), math.rotate(back, placed.forward));
                wings.Add(new FlightWing
                {
                    Rig = wing.rig,
                    Parameters = wing.values.parameters,
                    Hinge = math.rotate(back, placed.hinge - (float3)live.root.position) / m_Units,
                    Axes = axes,
                    Length = wing.values.size.wingLength,
                    Mass = wing.values.size.wingMass,
                    GravityShare = wing.values.size.gravityShare,
                    IsLeft = math.dot(math.cross(axes.c0, axes.c1), axes.c2) < 0f,
                });
            }

            return wings;
        }

        private void Detach()
        {
            if (m_Table != null)
                FlightTrims.Return(m_Table);
            m_Table = null;
            m_Model?.Dispose();
            m_Model = null;
            if (m_World != null && ReferenceEquals(WingSystem.Crowd?.World, m_World))
            {
                m_World.RemoveBody(m_Body);
                for (int k = 0; m_Live != null && k < m_Live.wings.Length; k++)
                {
                    if (m_World.Contains(m_Live.wings[k].handle))
                        m_World.ReleaseDrive(m_Live.wings[k].handle);
                }
            }

            m_World = null;
            m_Live = null;
        }

        private void Show(LiveInsect live, WingWorld world, float alpha)
        {
            if (!ReferenceEquals(live, m_Live) || !ReferenceEquals(world, m_World) || !world.Contains(m_Body))
                return;
            // Moved by somebody since: the next step takes it over.
            if (transform.position != m_ShownPosition || transform.rotation != m_ShownRotation)
                return;
            ref FlyingBody body = ref world.Body(m_Body);
            Quaternion rotation = math.slerp((quaternion)m_FromRotation, body.rotation, math.saturate(alpha));
            Show(rotation, m_From + (Vector3)(body.position * (m_Units * math.saturate(alpha))));
        }

        private void Show(Quaternion rotation, Vector3 centre)
        {
            transform.SetPositionAndRotation(centre - rotation * (Vector3)(m_Model.Centre * m_Units), rotation);
            m_ShownPosition = transform.position;
            m_ShownRotation = transform.rotation;
        }

        private static float HeadingOf(Quaternion rotation)
        {
            Vector3 ahead = rotation * Vector3.forward;
            return math.atan2(ahead.x, ahead.z);
        }

        private sealed class Link : IFlyingInsect
        {
            private readonly InsectFlight m_Flight;

            public Link(InsectFlight flight) => m_Flight = flight;

            public void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float dt) => m_Flight.Prepare(live, world, wind, gravity, dt);

            public void Show(LiveInsect live, WingWorld world, float alpha) => m_Flight.Show(live, world, alpha);
        }
    }
}
