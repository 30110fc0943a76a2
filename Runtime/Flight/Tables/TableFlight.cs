using System;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Flies halfway between the points of a table. Trims of two kinds may close side by side, and what is mixed of their gains holds
    /// neither: the one farther from level flight is taken out then, and what lies beyond it.
    /// </summary>
    internal static class TableFlight
    {
        /// <summary>Seconds of a flight and its steps.</summary>
        private const float k_Seconds = 4f, k_Step = 0.01f;

        /// <summary>Tilt, radians, and error of the velocity, m/s, from which an insect is lost.</summary>
        private const float k_MostTilt = 0.8f, k_MostError = 0.6f;

        /// <summary>Seconds of a flight that shows whether trims mix well, share of it after which the tilt counts, and the tilt.</summary>
        private const float k_MixingSeconds = 6f, k_Counted = 0.5f, k_MixingTilt = 4f * math.PI / 180f;

        /// <summary>Takes the points out that the insect cannot fly to from level flight.</summary>
        public static void Check(FlightModel model, TrimTable table, Action<string> log)
        {
            int level = table.LevelClimb;
            for (int s = 0; s < table.Speeds.Length; s++)
            {
                foreach (int way in new[] { -1, 1 })
                {
                    bool holds = true;
                    for (int c = level + way; c >= 0 && c < table.ClimbRates.Length; c += way)
                    {
                        if (!table.IsClosed(s, c) || !table.IsClosed(s, c - way) && holds)
                            continue;
                        var between = new FlightCondition(table.Speeds[s], 0.5f * (table.ClimbRates[c] + table.ClimbRates[c - way]));
                        holds = holds && Holds(model, table, between);
                        if (holds)
                            continue;
                        log?.Invoke($"{between}: the trims around it do not mix; "
                            + $"{new FlightCondition(table.Speeds[s], table.ClimbRates[c])} is left out.");
                        table.Open(s, c);
                    }
                }
            }
        }

        /// <summary>
        /// Returns true where the insect flies by what is mixed of the trims around a condition, and comes to lie in the mixed attitude.
        /// </summary>
        public static bool Mixes(FlightModel model, TrimTable table, in FlightCondition condition) =>
            Flies(model, table, condition, k_MixingSeconds, k_Counted * k_MixingSeconds, k_MixingTilt);

        private static bool Holds(FlightModel model, TrimTable table, in FlightCondition condition) =>
            Flies(model, table, condition, k_Seconds, 0f, k_MostTilt);

        // The tilt counts from a time on.
        private static bool Flies(
            FlightModel model, TrimTable table, in FlightCondition condition, float seconds, float counted, float mostTilt)
        {
            // Between the points themselves: the guard of commands keeps a slow insect from climbing and sinking as fast.
            using var flight = new FreeFlight(model, table, condition) { GuardCommands = false };
            var command = FlightCommand.Fly(new float3(0f, condition.Climb, condition.Speed), 0f);
            while (flight.Time < seconds)
            {
                flight.Step(command, k_Step);
                if (flight.Time > counted && !(flight.Tilt < mostTilt) || !(math.length(flight.VelocityError) < k_MostError))
                    return false;
            }

            return true;
        }
    }
}
