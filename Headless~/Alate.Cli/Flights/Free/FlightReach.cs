using Alate.Flight;

namespace Alate.Cli;

/// <summary>Flights that an insect has no trims for.</summary>
internal static class FlightReach
{
    /// <summary>Tells at which speeds an insect moves level, where it cannot hover or cannot climb.</summary>
    /// <returns>Null where it hovers and climbs.</returns>
    public static string Missing(TrimTable table)
    {
        List<float> level = [];
        bool climbs = false;
        for (int s = 0; s < table.Speeds.Length; s++)
        {
            List<float> rates = [.. table.ClimbRates.Where((_, c) => table.IsClosed(s, c))];
            climbs |= rates.Exists(rate => rate > 0f);
            if (rates.Exists(rate => rate <= 0f) && rates.Exists(rate => rate >= 0f))
                level.Add(table.Speeds[s]);
        }

        bool hovers = level.Contains(0f);
        if (hovers && climbs)
            return null;
        string cannot = hovers ? "cannot climb" : climbs ? "cannot hover" : "can neither hover nor climb";
        return level.Count == 0
            ? "by its trim table it sinks at every speed"
            : FormattableString.Invariant($"by its trim table it moves level at {level[0]:0.##} to {level[^1]:0.##} m/s and {cannot}");
    }
}
