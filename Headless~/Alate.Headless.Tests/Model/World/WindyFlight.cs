using System;
using System.Linq;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// Wings that meet wind from many sides at once, one each, in steps of one of their substeps, and how far the edges of their skins
    /// stretch.
    /// </summary>
    internal static class WindyFlight
    {
        /// <summary>The 26 directions of a cube's corners, edges and faces.</summary>
        public static readonly float3[] Directions = (
            from x in new[] { -1, 0, 1 }
            from y in new[] { -1, 0, 1 }
            from z in new[] { -1, 0, 1 }
            where x != 0 || y != 0 || z != 0
            select math.normalize(new float3(x, y, z))).ToArray();

        /// <summary>Along the six axes.</summary>
        public static readonly float3[] SixDirections = Directions.Where(direction => math.cmax(math.abs(direction)) > 0.99f).ToArray();

        private static readonly float3[] s_None = [float3.zero];

        /// <summary>Measured stretches, as shares.</summary>
        /// <param name="Largest">Of all edges, moments and directions.</param>
        /// <param name="Share99">What 99 of 100 edges stay below over the time, in the worst direction.</param>
        /// <param name="Where">Direction and place of the largest stretch.</param>
        /// <param name="Resets">Of all wings.</param>
        public readonly record struct Stretch(double Largest, double Share99, string Where, int Resets)
        {
            public override string ToString() => FormattableString.Invariant($"{100 * Largest:F1} / {100 * Share99:F1} % {Where}");
        }

        /// <summary>Steady wind over the last two of some beats.</summary>
        /// <param name="flight">The wing.</param>
        /// <param name="wind">Metres a second.</param>
        /// <param name="directions">Where it blows to; null for all.</param>
        /// <param name="beats">How many to fly.</param>
        /// <param name="speed">Of the body, metres a second; null for its cruise.</param>
        public static Stretch Steady(SpeciesFlight flight, float wind, float3[] directions = null, int beats = 6, float? speed = null) =>
            Fly(flight, wind == 0f ? s_None : directions ?? Directions,
                direction => _ => flight.Air(wind * direction, speed ?? flight.Speed), beats - 2, beats);

        /// <summary>Two smooth gusts of a beat each and a sharp one of one and a half, over six beats.</summary>
        /// <param name="flight">The wing.</param>
        /// <param name="wind">Metres a second at their strongest.</param>
        public static Stretch Gusts(SpeciesFlight flight, float wind) =>
            Fly(flight, Directions, direction => beat => flight.Air(wind * Gust(beat) * direction), 1, 6);

        /// <summary>The largest bend of the tip over the last two of six beats, in a head wind, radians.</summary>
        public static double TipBend(SpeciesFlight flight, float headWind)
        {
            using var world = new WingWorld();
            WingHandle wing = world.Add(flight.Rig, flight.parameters, flight.Air(new float3(0f, 0f, -headWind), flight.Speed));
            var measurement = new BeatMeasurement(flight.Rest, flight.Triangles);
            int steps = flight.parameters.substepsPerBeat;
            float dt = 1f / (steps * world.Read(wing).Frequency);
            double largest = 0.0;
            for (int k = 0; k < 6 * steps; k++)
            {
                world.Step(dt);
                if (k < 4 * steps)
                    continue;
                world.Skin();
                WingReading reading = world.Read(wing);
                var frame = new BeatFrame(reading.Phase, reading.DrivenRotation(0, 0), flight.Vertices(world, wing));
                largest = Math.Max(largest, Math.Abs(measurement.Bend(frame)));
            }

            return largest;
        }

        private static Stretch Fly(
            SpeciesFlight flight, float3[] directions, Func<float3, Func<float, WingSurroundings>> airOf, int firstBeat, int beats)
        {
            using var world = new WingWorld();
            var edges = new EdgeStretch(flight.Rest, flight.Triangles);
            float[] stretches = new float[edges.Count];
            Func<float, WingSurroundings>[] airs = Array.ConvertAll(directions, direction => airOf(direction));
            WingHandle[] wings = Array.ConvertAll(airs, air => world.Add(flight.Rig, flight.parameters, air(0f)));
            int[][] counts = new int[directions.Length][];
            for (int k = 0; k < counts.Length; k++)
                counts[k] = new int[4001];
            int steps = flight.parameters.substepsPerBeat;
            float dt = 1f / (steps * world.Read(wings[0]).Frequency), largest = 0f;
            string where = "";
            for (int step = 0; step < beats * steps; step++)
            {
                for (int k = 0; k < wings.Length; k++)
                    world.SetSurroundings(wings[k], airs[k]((float)step / steps));
                world.Step(dt);
                if (step < firstBeat * steps)
                    continue;
                world.Skin();
                for (int k = 0; k < wings.Length; k++)
                {
                    float3[] skin = flight.Vertices(world, wings[k]);
                    edges.Measure(skin, stretches);
                    foreach (float stretch in stretches)
                        counts[k][math.min((int)(2000f * stretch), 4000)]++;
                    float worst = stretches.Max();
                    if (worst <= largest)
                        continue;
                    largest = worst;
                    where = FormattableString.Invariant(
                        $"to ({directions[k].x:F1}, {directions[k].y:F1}, {directions[k].z:F1}) {Place(flight, skin)}");
                }
            }

            return new Stretch(largest, counts.Max(Share99), where, wings.Sum(wing => world.Read(wing).Resets));
        }

        // The middle of the edge that stretches most, at rest.
        private static string Place(SpeciesFlight flight, float3[] skin)
        {
            double most = -1.0;
            float3 place = default;
            for (int k = 0; k < flight.Triangles.Length; k++)
            {
                int a = flight.Triangles[k], b = flight.Triangles[k % 3 == 2 ? k - 2 : k + 1];
                double length = math.distance(flight.Rest[a], flight.Rest[b]),
                    stretch = Math.Abs(math.distance(skin[a], skin[b]) / length - 1.0);
                if (!(stretch > most))
                    continue;
                most = stretch;
                place = 0.5f * (flight.Rest[a] + flight.Rest[b]);
            }

            return FormattableString.Invariant($"at span {place.x:F2}, chord {place.z:F2}");
        }

        private static double Share99(int[] counts)
        {
            long all = counts.Sum(count => (long)count), below = 0;
            for (int k = 0; k < counts.Length; k++)
            {
                below += counts[k];
                if (below >= 0.99 * all)
                    return (k + 1) / 2000.0;
            }

            return 2.0;
        }

        private static float Gust(float beat) => beat < 1.5f || beat >= 5.5f ? 0f
            : beat < 3.5f ? 0.5f - 0.5f * math.cos(2f * math.PI * (beat - 1.5f))
            : beat < 4f ? 0f : 1f;
    }
}
