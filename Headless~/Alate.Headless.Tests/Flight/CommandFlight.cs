using System;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>
    /// Flight by commands that heed nothing: of a pilot who flies straight for a goal, or of a script of random velocities and headings.
    /// </summary>
    internal sealed class CommandFlight
    {
        /// <summary>Seconds of a flight.</summary>
        private const double k_Seconds = 15;

        /// <summary>Farthest goal, metres.</summary>
        private const float k_Farthest = 8f;

        private readonly FlyingInsect m_Insect;
        private readonly float m_Step;

        public CommandFlight(FlyingInsect insect, float step)
        {
            m_Insect = insect;
            m_Step = step;
        }


        /// <summary>False does as told.</summary>
        public bool GuardCommands { get; set; } = true;

        /// <summary>Longest tumble, seconds.</summary>
        public double Tumbled { get; private set; }

        /// <summary>Farthest from where the reference went, metres.</summary>
        public double Lost { get; private set; }

        /// <summary>Distance from the goal at the end, metres.</summary>
        public double Missed { get; private set; }

        /// <summary>Flies for a goal in any direction, from any start speed, as fast as told until half a metre before it.</summary>
        public void ForAGoal(uint seed)
        {
            var random = new Unity.Mathematics.Random(seed * 747796405u + 1u);
            float3 goal = random.NextFloat(0.5f, k_Farthest) * random.NextFloat3Direction();
            float top = m_Insect.Table.TopSpeed;
            using FreeFlight flight = Start(ref random);
            ForAGoal(flight, goal, random.NextFloat(0.2f, 1.5f) * top);
        }

        /// <summary>Flies from hovering straight for a goal, metres ahead along Z, at up to 1 m/s.</summary>
        public void ForAGoal(float3 goal)
        {
            using var flight = new FreeFlight(m_Insect.Model, m_Insect.Table);
            ForAGoal(flight, goal, 1f);
        }

        /// <summary>Flies a script: every 0.2 to 3 s another velocity, and often a heading, which may spin.</summary>
        public void ByAScript(uint seed)
        {
            var random = new Unity.Mathematics.Random(seed * 747796405u + 1u);
            using FreeFlight flight = Start(ref random);
            FlightCommand command = default;
            double next = 0;
            float spin = 0f;
            Fly(flight, () =>
            {
                if (flight.Time >= next)
                {
                    next += random.NextFloat(0.2f, 3f);
                    float speed = random.NextFloat() < 0.1f ? 100f : 2f * random.NextFloat();
                    command.velocity = speed * random.NextFloat3Direction();
                    if (random.NextFloat() < 0.05f)
                        command.velocity.x = float.NaN;
                    command.heading = random.NextFloat() < 0.5f ? float.NaN : random.NextFloat(-math.PI, math.PI);
                    spin = random.NextFloat() < 0.3f ? random.NextFloat(-20f, 20f) : 0f;
                }

                command.heading += spin * m_Step;
                return command;
            });
        }

        private void ForAGoal(FreeFlight flight, float3 goal, float speed)
        {
            Fly(flight, () =>
            {
                float3 way = goal - flight.Position;
                return FlightCommand.Fly(math.min(speed, 2f * math.length(way)) * math.normalizesafe(way));
            });
            Missed = math.distance(goal, flight.Position);
        }

        private FreeFlight Start(ref Unity.Mathematics.Random random) => new FreeFlight(m_Insect.Model, m_Insect.Table,
            new FlightCondition(random.NextFloat() * m_Insect.Table.TopSpeed, 0f), random.NextFloat(-math.PI, math.PI));

        private void Fly(FreeFlight flight, Func<FlightCommand> pilot)
        {
            flight.GuardCommands = GuardCommands;
            float3 asked = flight.Position;
            double tumble = 0;
            Tumbled = Lost = 0;
            while (flight.Time < k_Seconds)
            {
                flight.Step(pilot(), m_Step);
                asked += flight.Reference.Velocity * m_Step;
                tumble = flight.State == FlightState.Tumbling ? tumble + m_Step : 0;
                Tumbled = math.max(Tumbled, tumble);
                Lost = math.max(Lost, (double)math.distance(asked, flight.Position));
            }
        }
    }
}
