using System.Collections.Generic;
using System.Globalization;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// All that decides a flight: who flies by which numbers, the start, and of each step the air, gravity, command and length.
    /// </summary>
    internal sealed class FlightRecording
    {
        /// <summary>Format that is written and read.</summary>
        public const int Format = 1;

        /// <summary>Most steps: 46 hours at 60 a second.</summary>
        public const int MostSteps = 10000000;

        /// <summary>Version of the package that flew.</summary>
        public string Package { get; set; } = "";

        /// <summary>Name in the catalogue; empty where only <see cref="Key"/> tells.</summary>
        public string Insect { get; set; } = "";

        /// <summary>Key of the numbers by which the insect flies.</summary>
        public uint Key { get; set; }

        /// <summary>Options by which the flight was asked for, to be read by people.</summary>
        public string Options { get; set; } = "";

        /// <summary>Start.</summary>
        public FlightStart Start { get; set; }

        /// <summary>Wings in the order of the flight's model; empty where they are those of the catalogue.</summary>
        public List<RecordedPlace> Wings { get; } = new List<RecordedPlace>();

        /// <summary>Steps in order.</summary>
        public List<RecordedStep> Steps { get; } = new List<RecordedStep>();

        /// <summary>Pushes in the order of their steps.</summary>
        public List<RecordedPush> Pushes { get; } = new List<RecordedPush>();

        /// <summary>Seconds flown.</summary>
        public double Seconds
        {
            get
            {
                double seconds = 0.0;
                foreach (RecordedStep step in Steps)
                    seconds += step.count * (double)step.length;
                return seconds;
            }
        }

        /// <summary>Key as files have it.</summary>
        public string KeyText => Key.ToString("x8", CultureInfo.InvariantCulture);

        /// <summary>Wings of a model in the places and the order of the recording; those of the model where it has none.</summary>
        /// <returns>Null where the recording has other wings than the model.</returns>
        public IReadOnlyList<FlightWing> PlacedWings(IReadOnlyList<FlightWing> wings)
        {
            if (Wings.Count == 0)
                return wings;
            if (Wings.Count != wings.Count)
                return null;
            var placed = new List<FlightWing>();
            foreach (RecordedPlace place in Wings)
            {
                bool left = math.dot(math.cross(place.axes.c0, place.axes.c1), place.axes.c2) < 0f;
                FlightWing nearest = null;
                foreach (FlightWing wing in wings)
                {
                    if (wing.IsLeft != left)
                        continue;
                    if (nearest == null || math.distance(wing.Hinge, place.hinge) < math.distance(nearest.Hinge, place.hinge))
                        nearest = wing;
                }

                if (nearest == null)
                    return null;
                placed.Add(new FlightWing
                {
                    Rig = nearest.Rig,
                    Parameters = nearest.Parameters,
                    Hinge = place.hinge,
                    Axes = place.axes,
                    Length = nearest.Length,
                    Mass = nearest.Mass,
                    GravityShare = nearest.GravityShare,
                    IsLeft = left,
                });
            }

            return placed;
        }

        /// <summary>Starts the flight.</summary>
        public FreeFlight StartFlight(FlightModel model, TrimTable table) => new FreeFlight(model, table, Start);

        /// <summary>Flies one of the steps.</summary>
        /// <param name="flight">The flight, with all steps before flown.</param>
        /// <param name="step">Number of the step.</param>
        /// <param name="push">Number of the next push; moves on.</param>
        public void Fly(FreeFlight flight, int step, ref int push)
        {
            for (; push < Pushes.Count && Pushes[push].step <= step; push++)
                flight.Push(Pushes[push].rotation, Pushes[push].velocity, Pushes[push].spin, Pushes[push].turn);
            RecordedStep at = Steps[step];
            flight.Wind = at.wind;
            flight.Gravity = at.gravity;
            flight.Aid = at.aid;
            flight.GuardCommands = !at.isUnguarded;
            flight.Step(FlightCommand.Fly(at.velocity, at.heading), at.length, at.count);
        }
    }
}
