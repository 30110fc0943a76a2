using Alate.Flight;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Flies the erratic track of a butterfly within a box about the start, as the component Wander Pilot does without obstacles.
/// </summary>
internal sealed class CoursePilot(int seed) : IFlightPilot
{
    private static readonly FlightVolume s_Volume = new(VolumeShape.Box, Vector3.zero, new Vector3(12f, 4f, 12f));

    private readonly ErraticCourse m_Course = new(seed);

    public FlightCommand Command(in FlightSituation situation) =>
        FlightCommand.Fly(m_Course.Next(situation, s_Volume, WanderSettings.Default));
}
