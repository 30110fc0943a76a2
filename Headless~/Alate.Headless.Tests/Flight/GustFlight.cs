using Alate.Flight;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.FreeFlights
{
    /// <summary>
    /// Flight of an insect that hovers or wanders, without aid, into one gust: the discrete gust of MIL-F-8785C and CS-25, a cosine up,
    /// held, and a cosine down, in which the air moves alike over the whole insect.
    /// </summary>
    internal sealed class GustFlight
    {
        /// <summary>
        /// Seconds in which a gust sets in and dies down, and for which it holds: one to two beats of a monarch, too fast to follow, and
        /// longer than an insect takes to go with the air, so that its end is a second gust.
        /// </summary>
        public const float Rise = 0.15f, Hold = 0.5f;

        /// <summary>
        /// Seconds before a gust while the insect hovers and while it wanders, up to a beat of the slowest insect more, and seconds after.
        /// </summary>
        private const float k_Hovers = 0.5f, k_Wanders = 3f, k_Beat = 0.1f, k_After = 4f;

        /// <summary>Metres within which an insect recovers.</summary>
        private const double k_Lost = 3;

        /// <summary>Error of the velocity, m/s, below which an insect follows its reference again.</summary>
        private const float k_Follows = 0.5f;

        private static readonly FlightVolume s_Volume = new FlightVolume(VolumeShape.Box, Vector3.zero, new Vector3(4f, 1.6f, 4f));

        private readonly FlyingInsect m_Insect;
        private readonly float m_Step;

        public GustFlight(FlyingInsect insect, float step)
        {
            m_Insect = insect;
            m_Step = step;
        }

        /// <summary>Longest tumble, seconds.</summary>
        public double Tumbled { get; private set; }

        /// <summary>Farthest from where a tumble began until the insect followed its reference again, metres.</summary>
        public double TumbleWay { get; private set; }

        /// <summary>Farthest from where the reference went, metres.</summary>
        public double Lost { get; private set; }

        /// <summary>Farthest below where the gust met it, metres.</summary>
        public double Sunk { get; private set; }

        /// <summary>Seconds from the gust to the last beat that did not follow.</summary>
        public double Recovery { get; private set; }

        /// <summary>True where the insect flies as its reference does at the end.</summary>
        public bool Flies { get; private set; }

        /// <summary>True where the insect flies on at the end, and was never more than 3 m off.</summary>
        public bool Recovers => Flies && TumbleWay <= k_Lost && Lost <= k_Lost;

        /// <summary>Flies.</summary>
        /// <param name="gust">Velocity of the air, m/s.</param>
        /// <param name="wanders">False hovers, looking along Z.</param>
        /// <param name="seed">Of the wandering, and of the phase of the beat that the gust meets.</param>
        public void Fly(float3 gust, bool wanders, int seed)
        {
            using var flight = new FreeFlight(m_Insect.Model, m_Insect.Table);
            var course = new ErraticCourse(seed);
            double start = (wanders ? k_Wanders : k_Hovers) + k_Beat * Random.CreateFromIndex((uint)seed).NextFloat();
            double end = start + 2 * Rise + Hold + k_After;
            float3 asked = default, met = default, fell = default;
            double tumble = 0;
            bool isUpset = false;
            Tumbled = TumbleWay = Lost = Sunk = Recovery = 0;
            while (flight.Time < end)
            {
                bool blows = flight.Time >= start;
                flight.Wind = gust * Share((float)(flight.Time - start));
                var command = FlightCommand.Fly(
                    wanders ? course.Next(flight.Situation(m_Step), s_Volume, WanderSettings.Default) : default);
                if (!blows)
                    met = asked = flight.Position;
                flight.Step(command, m_Step);
                asked += flight.Reference.Velocity * m_Step;
                bool tumbles = flight.State == FlightState.Tumbling;
                tumble = tumbles ? tumble + m_Step : 0;
                if (!blows && !tumbles)
                    continue;
                Flies = !tumbles && math.length(flight.VelocityError) < k_Follows;
                if (tumbles && !isUpset)
                    fell = flight.Position;
                isUpset = tumbles || (isUpset && !Flies);
                Tumbled = math.max(Tumbled, tumble);
                if (isUpset)
                    TumbleWay = math.max(TumbleWay, (double)math.distance(fell, flight.Position));
                Lost = math.max(Lost, (double)math.distance(asked, flight.Position));
                Sunk = math.max(Sunk, (double)(met.y - flight.Position.y));
                if (!Flies)
                    Recovery = flight.Time - start;
            }
        }

        private static float Share(float time)
        {
            float whole = 2f * Rise + Hold;
            if (time <= 0f || time >= whole)
                return 0f;
            float part = math.min(math.min(time, whole - time) / Rise, 1f);
            return 0.5f - 0.5f * math.cos(math.PI * part);
        }
    }
}
