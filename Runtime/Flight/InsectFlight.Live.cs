using System;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>The flight while it lives: its body in the world of the wings.</summary>
    public sealed partial class InsectFlight
    {
        /// <summary>Turn within a step that contacts may cause, degrees.</summary>
        private const float k_MostPushed = 60f;

        /// <summary>Most world units of a metre: an insect that is drawn larger has no size.</summary>
        private const float k_MostUnits = 1e6f;

        private InsectWings m_Wings;
        private Link m_Link;
        private CarriedRigidbody m_Carried;
        private WingWorld m_World;
        private LiveInsect m_Live;
        private BodyHandle m_Body;
        private FlightModel m_Model;
        private TrimTable m_Table;
        private FlightReference m_Reference;
        private Perching m_Perching;
        private TumbleWatch m_Tumbles;
        private double m_Time;
        private float m_Units;
        private Vector3 m_ShownPosition;
        private Quaternion m_ShownRotation, m_FromRotation;
        private Vector3 m_From;
        private GuardedVector m_Wanted;

        private void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float length, int count)
        {
            if (!IsAttached(live, world))
                return;
            if (IsLost(world.Body(m_Body)) && !StartAgain(live, world))
                return;
            ref FlyingBody body = ref world.Body(m_Body);
            PlacedWing placed = live.wings[0].placed;
            float metres = live.insect.MotionSettings.metresPerUnit;
            float units = metres > 0f ? 1f / metres : placed.length / live.wings[0].values.size.wingLength;
            if (!placed.isValid || !(units <= k_MostUnits))
            {
                // Without a size it stays where it is.
                body.position = body.positionRest = default;
                m_Recorder?.End("the insect has no size");
                return;
            }

            float dt = length * count;
            if (IsRecording && live.Detail != WingDetail.Full)
                m_Recorder.End($"the wings were computed as {live.Detail}, not in full");
            FlightState before = State;
            m_Units = units;
            TakeOver(ref body, dt);
            body.wind = wind / m_Units;
            body.weight = gravity * m_Model.GravityShare;
            body.gravity = gravity;
            body.aid = Aid;
            Fly(ref body, length, count);
            m_Time += dt;
            if (m_World == null)
                return;
            if (m_Carried != null)
            {
                Show(body.rotation, m_From);
                m_Carried.Move(m_ShownPosition, m_ShownRotation, dt);
            }

            if (m_Tumbles.Step(State == FlightState.Tumbling, (float3)BodyVelocity * dt, m_Time, dt))
                Raise(m_Tumbles.IsTumbling ? TumbleBegan : TumbleEnded);
            if (State == FlightState.Perched && before != FlightState.Perched)
                Raise(Landed);
            else if (State != FlightState.Perched && before == FlightState.Perched)
                Raise(TookOff);
        }

        // Between steps: where the body has got to becomes where the next step starts; whoever moved the object meanwhile has moved the
        // body.
        private void TakeOver(ref FlyingBody body, float dt)
        {
            var moved = (Vector3)(body.position * m_Units);
            m_From += moved;
            body.position = body.positionRest = default;
            float turn = 0f;
            m_Recorder?.Keep(body);
            if (m_Carried != null && !m_Carried.IsThere)
                m_Carried = null;
            if (m_Carried != null)
                turn = TakeOverPushes(ref body, moved);
            else if (transform.position != m_ShownPosition || transform.rotation != m_ShownRotation)
                turn = Teleported(ref body, m_ShownPosition, m_ShownRotation, transform.position, transform.rotation);
            m_Recorder?.Pushed(body, turn);
            m_FromRotation = body.rotation;
            Position = m_From;
            BodyVelocity = m_Perching.Holds ? moved / (m_Units * math.max(dt, 1e-6f)) : (Vector3)body.velocity;
            AidPower = body.aidPower;
            Force = body.force / math.max(m_Model.Weight, 1e-12f);
        }

        // What contacts have turned and stopped within a step goes into the flight; a larger turn or a perched insect's jump is somebody's
        // who places it.
        private float TakeOverPushes(ref FlyingBody body, Vector3 moved)
        {
            Vector3 before = m_ShownPosition, position = m_Carried.Position;
            if (!m_Carried.IsSound)
            {
                // Nobody's push, nor a place: the body goes on as its wings carry it.
                m_Carried.Place(before, m_ShownRotation);
                return 0f;
            }

            float turn = Quaternion.Angle(Quaternion.identity, m_Carried.Turned);
            bool jumped = (position - before).magnitude > m_Model.Length * m_Units;
            if (turn > k_MostPushed || m_Perching.Holds && jumped)
            {
                return Teleported(ref body, before, m_ShownRotation, position, m_Carried.Rotation);
            }

            if (!m_Perching.Holds)
            {
                m_From = position + m_Carried.Rotation * (Vector3)(m_Model.Centre * m_Units) + moved;
                body.rotation = math.normalize(math.mul(m_Carried.Turned, body.rotation));
                body.velocity += (float3)m_Carried.Pushed / m_Units;
                body.spin += math.rotate(math.conjugate(body.rotation), m_Carried.Spun);
            }

            return 0f;
        }

        /// <returns>Turn of the reference, radians.</returns>
        private float Teleported(ref FlyingBody body, Vector3 from, Quaternion fromRotation, Vector3 to, Quaternion toRotation)
        {
            // The turn about the vertical is taken over; pitch and roll are the flight's own.
            float turn = Headings.Of(toRotation) - Headings.Of(fromRotation);
            quaternion turned = Rotations.AboutY(turn);
            bool turns = math.abs(turn) > 1e-3f;
            if (turns)
            {
                body.rotation = math.mul(turned, body.rotation);
                body.velocity = math.rotate(turned, body.velocity);
                m_Reference = m_Reference.Turned(turn);
            }

            if (m_Perching.Holds)
                m_Perching.Carry(from, to, turned);
            m_From = to + (Vector3)math.rotate(toRotation, m_Model.Centre * m_Units);
            Show(body.rotation, m_From);
            return turns ? turn : 0f;
        }

        private void Fly(ref FlyingBody body, float length, int count)
        {
            float dt = length * count;
            FlightCommand command = m_Seat.Command(Situation(body, dt), FlightCommand.Fly(Velocity, Heading));
            // The pilot may have switched the insect off.
            if (m_World == null)
                return;
            command.velocity = m_Wanted.Guard(command.velocity, float.MaxValue, "a wanted velocity", "m/s", this);
            if (!OuterBounds.Hold(command.heading, OuterBounds.Turning))
                command.heading = float.NaN;
            bool sits = command.wish == FlightWish.Perch && command.spot.IsPossible && math.isfinite(command.spot.heading);
            if (sits && !m_Perching.Holds)
                Perch(ref body, command.spot);
            if (m_Perching.Holds)
                m_Recorder?.End("the insect sits");
            if (m_Perching.Holds && Hold(ref body, sits, command, dt))
                return;

            m_Recorder?.Add(body, command, GuardCommands, length, count);
            m_Reference.Lead(ref body, command, m_Table, GuardCommands, dt);
            State = body.Tumbles ? FlightState.Tumbling : command.wish == FlightWish.Land ? FlightState.Landing : FlightState.Flying;
        }

        private FlightSituation Situation(in FlyingBody body, float dt)
        {
            FlightSituation situation = m_Reference.Situation(body);
            situation.position = m_From;
            situation.state = State;
            situation.limits = Limits;
            situation.time = m_Time;
            situation.deltaTime = dt;
            situation.wingLength = m_Model.Length;
            situation.unitsPerMetre = m_Units;
            if (m_Perching.Holds)
                situation.heading = Headings.Of(body.rotation);
            return situation;
        }

        /// <summary>World units of a metre of the insect.</summary>
        internal float UnitsPerMetre => m_Units;

        private float3 Legs => ((float3)m_Live.wings[0].values.Feet - m_Model.Centre) * m_Units;

        private void Perch(ref FlyingBody body, in PerchSpot spot)
        {
            m_Perching = new Perching(ref body, spot, m_From, Legs, Landing.Clearance * m_Model.Length, m_Model.Frequency, m_Units);
        }

        // Where the perch moves the body, the way goes into its position, as in flight, and is drawn between steps.
        private bool Hold(ref FlyingBody body, bool sits, in FlightCommand command, float dt)
        {
            var wings = new HeldWings(m_World, m_Body, m_Live, m_Model, m_Table);
            m_Perching.Units = m_Units;
            if (command.spot.IsPossible && math.lengthsq(command.spot.normal) > 0f)
                m_Perching.Follow(ref body, command.spot);
            if (sits)
                m_Perching.Sit(ref body, wings, dt);
            else
                m_Perching.Start(ref body, wings, command.heading, dt);
            float3 centre = m_Perching.Centre(body.rotation, Legs);
            State = m_Perching.IsSeated ? FlightState.Perched : sits ? FlightState.Landing : FlightState.Flying;
            if (m_Perching.Holds)
            {
                body.position = (centre - (float3)m_From) / m_Units;
                return true;
            }

            m_From = centre;
            TakeOff(ref body);
            return false;
        }

        private void TakeOff(ref FlyingBody body)
        {
            float heading = Headings.Of(body.rotation);
            m_Reference = new FlightReference(m_Perching.Jump, heading, body.wind);
            body.reference = new BodyReference { velocity = m_Perching.Jump, heading = heading };
            body.mode = BodyMode.Free;
            body.Forget();
            m_World.PlaceOnBob(m_Body);
            m_FromRotation = body.rotation;
        }

        private void Raise(Action<InsectFlight> told)
        {
            try
            {
                told?.Invoke(this);
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, this);
            }
        }

        private void Show(LiveInsect live, WingWorld world, float alpha)
        {
            if (m_Carried != null || !live.wings[0].placed.isValid || !ReferenceEquals(live, m_Live) || !ReferenceEquals(world, m_World)
                || !world.Contains(m_Body))
            {
                return;
            }
            // Moved by somebody since: the next step takes it over.
            if (transform.position != m_ShownPosition || transform.rotation != m_ShownRotation)
                return;
            ref FlyingBody body = ref world.Body(m_Body);
            if (IsLost(body))
                return;
            alpha = m_Perching.IsSeated ? 1f : math.saturate(alpha);
            quaternion rotation = Rotations.Slerp((quaternion)m_FromRotation, body.rotation, alpha);
            float3 centre = m_From + (Vector3)(body.position * (m_Units * alpha));
            if (m_Perching.Holds && m_Seat.TryFindPerch(out PerchSpot perch))
                m_Perching.Show(perch, alpha, ref rotation, ref centre);
            Show(rotation, centre);
        }

        private void Show(Quaternion rotation, Vector3 centre)
        {
            m_ShownPosition = Origin(rotation, centre);
            m_ShownRotation = rotation;
            if (m_Carried != null)
                return;
            transform.SetPositionAndRotation(m_ShownPosition, rotation);
            m_ShownPosition = transform.position;
            m_ShownRotation = transform.rotation;
        }

        private Vector3 Origin(Quaternion rotation, Vector3 centre) => centre - rotation * (Vector3)(m_Model.Centre * m_Units);

        private sealed class Link : IFlyingInsect
        {
            private readonly InsectFlight m_Flight;

            public Link(InsectFlight flight) => m_Flight = flight;

            public void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float length, int count) =>
                m_Flight.Prepare(live, world, wind, gravity, length, count);

            public void Show(LiveInsect live, WingWorld world, float alpha) => m_Flight.Show(live, world, alpha);
        }
    }
}
