using System;
using Alate.Cli;

namespace Alate.Tests.Cli
{
    /// <summary>A monarch's flight that the tests of its files share; none of them changes it.</summary>
    internal static class MonarchFlight
    {
        private static readonly Lazy<FlightRecord> s_Level = new Lazy<FlightRecord>(() => Fly(new FlightPlan { Species = "monarch" }));

        /// <summary>Level flight in still air: the left wing mirrors the right one.</summary>
        public static FlightRecord Level => s_Level.Value;

        /// <summary>Flies a plan of its own.</summary>
        public static FlightRecord Fly(FlightPlan plan) => TetheredFlight.Fly(plan);
    }
}
