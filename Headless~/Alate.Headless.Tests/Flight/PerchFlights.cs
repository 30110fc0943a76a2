using System.Collections.Concurrent;
using Alate.Catalogue;
using Alate.Flight;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Landings of a species on small pads, flown by its own wings.</summary>
    internal sealed class PerchFlights
    {
        private const float k_Step = 0.02f, k_Patience = 120f, k_LeavingTime = 3f, k_ComingTime = 4f;

        private static readonly ConcurrentDictionary<string, PerchFlights> s_Known = new ConcurrentDictionary<string, PerchFlights>();

        private readonly FlightModel m_Model;
        private readonly TrimTable m_Table;
        private readonly float m_Stand;

        private PerchFlights(string name)
        {
            InsectDefinition species = FlownInsects.Find(name);
            m_Model = CatalogueFlight.CreateModel(species);
            m_Table = CatalogueFlight.CreateTable(species, m_Model);
            m_Stand = -species.Wings[0].CreatePreset().Rest.feet.y;
        }

        public float WingLength => m_Model.Length;

        /// <summary>The species' flights.</summary>
        public static PerchFlights Of(string name) => s_Known.GetOrAdd(name, _ => new PerchFlights(name));

        /// <summary>
        /// Flies to a random spot of a slope within a range, degrees, from above it, or from below what overhangs by more than 90°, and off
        /// again.
        /// </summary>
        public PerchFlight Fly(int seed, float leastSlope = 0f, float mostSlope = 45f, float wind = 0f)
        {
            PerchSpot spot = RandomSpot(seed, 1.2f, 0.8f, leastSlope, mostSlope);
            var record = new PerchFlight();
            using (var flight = new FreeFlight(m_Model, m_Table) { Wind = wind * Course(seed) })
                spot.heading = Down(flight, spot, record);
            if (record.Landed && wind == 0f)
                Leave(spot, spot.heading, record);
            return record;
        }

        /// <summary>Comes flying at a share of its top speed, brakes, and lands on a random spot of a slope up to 45°.</summary>
        /// <param name="seed">Of the spot.</param>
        /// <param name="share">Speed of coming over the top speed.</param>
        /// <param name="detail">Detail of the wings.</param>
        public PerchFlight FlyIn(int seed, float share, WingDetail detail)
        {
            using var flight = new FreeFlight(m_Model, m_Table);
            foreach (WingHandle wing in flight.Wings)
                flight.World.SetDetail(wing, detail);
            var ahead = new float3(0f, 0f, share * m_Table.TopSpeed);
            while (flight.Time < k_ComingTime)
                flight.Step(FlightCommand.Fly(ahead), k_Step);
            PerchSpot spot = RandomSpot(seed, 3f, 1.2f);
            spot.position += flight.Position;
            var record = new PerchFlight();
            Down(flight, spot, record);
            return record;
        }

        private static float3 Course(int seed)
        {
            math.sincos(Random.CreateFromIndex((uint)seed + 5000).NextFloat(2f * math.PI), out float sin, out float cos);
            return new float3(sin, 0f, cos);
        }

        // Below the origin, an overhang above it.
        private static PerchSpot RandomSpot(int seed, float farthest, float highest, float leastSlope = 0f, float mostSlope = 45f)
        {
            var random = Random.CreateFromIndex((uint)seed);
            float slope = math.radians(random.NextFloat(leastSlope, mostSlope)), way = random.NextFloat(0f, 2f * math.PI),
                from = random.NextFloat(0f, 2f * math.PI);
            var normal = new float3(math.sin(slope) * math.sin(way), math.cos(slope), math.sin(slope) * math.cos(way));
            float3 off = new float3(math.sin(from), 0f, math.cos(from)) * random.NextFloat(0f, farthest)
                + new float3(0f, random.NextFloat(0.35f, highest), 0f);
            off.y *= normal.y < 0f ? -1f : 1f;
            off -= math.min(math.dot(off, normal) - 0.3f, 0f) * normal;
            return new PerchSpot { position = -off, normal = normal, heading = random.NextFloat(-math.PI, math.PI) };
        }

        private float Down(FreeFlight flight, in PerchSpot spot, PerchFlight record)
        {
            var landing = new Landing(spot, m_Stand);
            while (flight.Time < k_Patience)
            {
                FlightSituation situation = flight.Situation(k_Step);
                FlightCommand command = landing.Next(situation);
                float3 place = situation.position - spot.position;
                if (command.wish == FlightWish.Perch)
                {
                    record.Landed = true;
                    record.HeldSpeed = math.length(situation.velocity);
                    record.MeanSpeed = math.length(situation.referenceVelocity);
                    record.Gap = math.dot(place, spot.normal) - m_Stand - Landing.Clearance * WingLength;
                    record.Beside = math.length(place - math.dot(place, spot.normal) * spot.normal);
                    break;
                }

                flight.Step(command, k_Step);
                record.Tumbled |= flight.State == FlightState.Tumbling;
                record.Lowest = math.min(record.Lowest, flight.Position.y - spot.position.y);
                record.Below = math.min(record.Below, math.dot(flight.Position - spot.position, spot.normal));
            }

            record.Seconds = (float)flight.Time;
            record.Attempts = landing.Attempts;
            return landing.Spot.heading;
        }

        // From where the legs have pushed the insect to: the wings beat in the trim of hovering.
        private void Leave(in PerchSpot spot, float heading, PerchFlight record)
        {
            using var flight = new FreeFlight(m_Model, m_Table, default, heading);
            var plan = new PerchPlan(1);
            PerchSettings settings = PerchSettings.Default;
            var seat = new PerchSpot
            {
                position = flight.Position
                - (m_Stand + Landing.Clearance * WingLength) * spot.normal,
                normal = spot.normal,
                heading = heading
            };
            plan.Sit(seat);
            float least = float.PositiveInfinity;
            while (flight.Time < k_LeavingTime)
            {
                flight.Step(
                    plan.Next(flight.Situation(k_Step), settings, flight.Position + spot.normal, FlightCommand.Fly(default)), k_Step);
                least = math.min(least, math.dot(flight.Position - seat.position, spot.normal));
                record.Tumbled |= flight.State == FlightState.Tumbling;
            }

            record.LeastHeight = least;
            record.LeftBehind = math.distance(flight.Position, seat.position);
        }
    }
}
