using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using Alate.Tests.Flight;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>An insect of the catalogue with its model and table, and the mission that it flies.</summary>
    internal sealed class FlyingInsect : IDisposable
    {
        public FlyingInsect(string species)
        {
            InsectDefinition insect = FlownInsects.Find(species);
            Model = CatalogueFlight.CreateModel(insect);
            Table = CatalogueFlight.CreateTable(insect, Model);
        }

        public FlightModel Model { get; }

        public TrimTable Table { get; }

        /// <summary>
        /// Flies hover, step to 1.3 m/s, turn by 90°, climb of 0.3 m/s, gusts of 1 m/s from the side and ahead, and a stop, without aid.
        /// </summary>
        /// <returns>Root mean squares of the velocity's error against the reference, mean over a beat, m/s, by part.</returns>
        public Dictionary<string, double> Mission(float dt)
        {
            (string Name, double From, double To)[] parts =
            [
                ("hover", 1, 5), ("step", 5, 8), ("cruise", 8, 12), ("turn", 12, 16), ("climb", 16, 20), ("side gust", 20, 23),
                ("head gust", 23, 26), ("stop", 26, 30), ("rest", 30, 35),
            ];
            var squares = new Dictionary<string, (double Sum, int Count)>();
            using var flight = new FreeFlight(Model, Table);
            var beat = new Queue<float3>();
            float3 sum = default;
            while (flight.Time < 35)
            {
                double time = flight.Time;
                float3 wanted = time < 5 || time >= 26 ? default : time < 12 ? new float3(0f, 0f, 1.3f) : new float3(
                    1.3f, time >= 16 && time < 20 ? 0.3f : 0f, 0f);
                flight.Wind =
                    time >= 20 && time < 21 ? new float3(0f, 0f, 1f) : time >= 23 && time < 24 ? new float3(-1f, 0f, 0f) : default;
                flight.Step(FlightCommand.Fly(wanted), dt);
                float3 error = flight.Velocity - flight.Reference.Velocity;
                beat.Enqueue(error);
                sum += error;
                double period = 1 / flight.World.Read(flight.Wings[0]).Frequency;
                // A beat; where steps catch it only once or twice, several, so that the bob does not count.
                double whole = period > 3 * dt ? period : Math.Ceiling(0.1 / period) * period;
                while (beat.Count > Math.Max(1, Math.Round(whole / dt)))
                    sum -= beat.Dequeue();
                double mean = math.length(sum) / beat.Count;
                foreach ((string name, double from, double to) in parts)
                {
                    if (time < from || time >= to)
                        continue;
                    squares.TryGetValue(name, out (double Sum, int Count) now);
                    squares[name] = (now.Sum + mean * mean, now.Count + 1);
                }
            }

            var errors = new Dictionary<string, double>();
            foreach ((string name, (double sumOf, int count)) in squares)
                errors[name] = Math.Sqrt(sumOf / count);
            return errors;
        }

        public void Dispose()
        {
            Table?.Dispose();
            Model.Dispose();
        }
    }
}
