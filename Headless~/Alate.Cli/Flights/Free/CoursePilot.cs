using Alate.Flight;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Flies the erratic track of a butterfly within a box about the start, as the component Wander Pilot does without obstacles.
/// </summary>
/// <param name="seed">Number of the track.</param>
/// <param name="erratic">0, a calm track, to 1.</param>
internal sealed class CoursePilot(int seed, double erratic = 0) : IFlightPilot
{
    private static readonly FlightVolume s_Volume = new(VolumeShape.Box, Vector3.zero, new Vector3(12f, 4f, 12f));

    private readonly ErraticCourse m_Course = new(seed);
    private readonly WanderSettings m_Settings = WanderSettings.Default with { erratic = (float)erratic };

    public FlightCommand Command(in FlightSituation situation) =>
        FlightCommand.Fly(m_Course.Next(situation, s_Volume, m_Settings));
}
