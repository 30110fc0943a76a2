using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// One insect that flies by its own wings in a world of its own, step by step: for tools, tests and measurements. Metres, seconds,
    /// kilograms.
    /// </summary>
    public sealed class FreeFlight : IDisposable
    {
        /// <summary>Beats until wings at rest are settled on the trim's beat.</summary>
        private const int k_SettledBeats = 4;

        private readonly FlightModel m_Model;
        private readonly TrimTable m_Table;
        private readonly WingWorld m_World = new WingWorld();
        private readonly List<WingHandle> m_Wings = new List<WingHandle>();
        private readonly BodyHandle m_Body;
        private FlightReference m_Reference;

        /// <summary>Starts in the trim of a condition, looking along a heading, at the origin.</summary>
        /// <param name="model">The insect; must live as long as the flight.</param>
        /// <param name="table">Its trims.</param>
        /// <param name="start">Speed and climb to start with.</param>
        /// <param name="heading">Radians about the world's up.</param>
        public FreeFlight(FlightModel model, TrimTable table, FlightCondition start = default, float heading = 0f)
            : this(model, table, new FlightStart { settled = true, condition = start, heading = heading })
        {
        }

        internal FreeFlight(FlightModel model, TrimTable table, in FlightStart start)
        {
            m_Model = model;
            m_Table = table;
            table.Acceleration = model.AccelerationAt(table.TopSpeed);
            FlyingBody body = model.CreateBody();
            body.mode = start.settled ? BodyMode.Held : BodyMode.Free;
            body.steered = 1;
            body.table = table.View;
            Elementary.SinCos(start.heading, out float sin, out float cos);
            FlightCondition condition = start.condition;
            var velocity = new float3(sin * condition.Speed, condition.Climb, cos * condition.Speed);
            body.reference =
                new BodyReference { velocity = velocity, heading = start.heading, airSpeed = condition.Speed, climb = condition.Climb };
            m_Reference = new FlightReference(velocity, start.heading, default);
            Gravity = body.gravity;
            m_Body = model.AddTo(m_World, body, m_Wings);
            if (start.settled)
                Settle();
            else
                Begin(start.phase);
        }

        /// <summary>Velocity of the air, m/s.</summary>
        public float3 Wind { get; set; }

        /// <summary>Gravity, m/s².</summary>
        internal float3 Gravity { get; set; }

        /// <summary>
        /// True keeps commands within what the insect flies, waits where it has not followed, and rights an insect that tumbles; false
        /// follows whatever is commanded, and an insect that is told to fly backwards, sideways or straight down tumbles.
        /// </summary>
        public bool GuardCommands { get; set; } = true;

        /// <summary>Outer help towards the wanted velocity and attitude, 0 to 1; 0 flies by the wings alone.</summary>
        public float Aid { get; set; }

        /// <summary>Seconds flown.</summary>
        public double Time { get; private set; }

        /// <summary>Centre of mass, metres.</summary>
        public float3 Position => Body.position;

        /// <summary>Rotation of the body, X right, Y up, Z ahead.</summary>
        public quaternion Rotation => Body.rotation;

        /// <summary>Velocity, m/s.</summary>
        public float3 Velocity => Body.velocity;

        /// <summary>Angular velocity about the world's axes, rad/s.</summary>
        public float3 AngularVelocity => math.rotate(Body.rotation, Body.spin);

        /// <summary>
        /// Force of air and aid on the insect, mean over the last step, N along the world's axes: rate of its momentum less its weight.
        /// </summary>
        public float3 Force => Body.force;

        /// <summary>Moment of the wings' air about the centre of mass, mean over the last step, N m in body axes.</summary>
        public float3 Moment => Body.moment;

        /// <summary>Power that the wings give to the air, mean over the last step, W.</summary>
        public float Power => Body.power;

        /// <summary>Power of the aid, mean over the last step, W.</summary>
        public float AidPower => Body.aidPower;

        /// <summary>Beats latched.</summary>
        public int Beats => Body.beats;

        /// <summary>Velocity less the bob, relative to the reference, at the last beat, m/s along the heading's axes.</summary>
        public float3 VelocityError => Body.velocityError;

        /// <summary>Turn of the body's up out of the trimmed attitude less the bob at the last beat, radians.</summary>
        internal float Tilt => Body.tilt;

        /// <summary>Commands that were clipped at the last beat.</summary>
        public int ClippedCommands => Body.clipped;

        /// <summary>Reference of the feedback.</summary>
        public FlightReference Reference => m_Reference;

        /// <summary>State of the flight.</summary>
        public FlightState State => Body.Tumbles ? FlightState.Tumbling : FlightState.Flying;

        /// <summary>Limits of the insect's flight.</summary>
        public FlightLimits Limits => m_Table.Limits;

        /// <summary>The wings' world, to read them.</summary>
        public WingWorld World => m_World;

        /// <summary>All wings, in the order of the model.</summary>
        public IReadOnlyList<WingHandle> Wings => m_Wings;

        private ref FlyingBody Body => ref m_World.Body(m_Body);

        /// <summary>Situation that a pilot is told.</summary>
        /// <param name="dt">Seconds of the coming step.</param>
        public FlightSituation Situation(float dt)
        {
            FlightSituation situation = m_Reference.Situation(Body);
            situation.state = State;
            situation.limits = Limits;
            situation.time = Time;
            situation.deltaTime = dt;
            situation.wingLength = m_Model.Length;
            return situation;
        }

        /// <summary>Flies a step towards a command.</summary>
        public void Step(in FlightCommand command, float dt) => Step(command, dt, 1);

        /// <summary>Flies steps towards a command that holds for all of them.</summary>
        internal void Step(in FlightCommand command, float length, int count)
        {
            ref FlyingBody body = ref Body;
            float dt = length * count;
            body.wind = Wind;
            body.weight = Gravity * m_Model.GravityShare;
            body.gravity = Gravity;
            body.aid = math.saturate(Aid);
            m_Reference.Lead(ref body, command, m_Table, GuardCommands, dt);
            for (int k = 0; k < count; k++)
                m_World.Step(length);
            Time += dt;
        }

        /// <summary>Gives the body another motion, and turns the reference about the world's up.</summary>
        internal void Push(quaternion rotation, float3 velocity, float3 spin, float turn)
        {
            ref FlyingBody body = ref Body;
            body.rotation = rotation;
            body.velocity = velocity;
            body.spin = spin;
            if (turn != 0f)
                m_Reference = m_Reference.Turned(turn);
        }

        /// <inheritdoc/>
        public void Dispose() => m_World.Dispose();

        private void Settle()
        {
            float h = 1f / (20f * Drive().frequency);
            for (int k = 0; k < 20 * k_SettledBeats; k++)
                m_World.Step(h);
            m_World.PlaceOnBob(m_Body);
            Body.mode = BodyMode.Free;
        }

        private void Begin(float phase)
        {
            WingDrive drive = Drive();
            foreach (WingHandle wing in m_Wings)
                m_World.Resume(wing, phase / (360f * drive.frequency));
            m_World.PlaceOnBob(m_Body);
        }

        // Lets the wings begin with the beat of the reference.
        private WingDrive Drive()
        {
            BodyReference reference = Body.reference;
            WingDrive drive = m_Table.DriveNear(reference.airSpeed, reference.climb);
            foreach (WingHandle wing in m_Wings)
            {
                m_World.SetDrive(wing, drive);
                m_World.Reset(wing);
            }

            return drive;
        }
    }
}
