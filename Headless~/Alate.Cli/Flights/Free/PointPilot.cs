using Alate.Flight;

namespace Alate.Cli;

/// <summary>Flies from point to point and holds the last one: as fast as it can still stop, and no faster than the insect flies.</summary>
internal sealed class PointPilot(IReadOnlyList<float3> points) : IFlightPilot
{
    /// <summary>Rate at which the last distance is closed, 1/s, and distance at which a point counts as reached, metres.</summary>
    private const float k_Rate = 0.8f, k_Reached = 0.5f;

    private int m_Next;

    public FlightCommand Command(in FlightSituation situation)
    {
        float3 way = points[m_Next] - situation.position;
        if (m_Next < points.Count - 1 && math.length(way) < k_Reached)
            way = points[++m_Next] - situation.position;
        float distance = math.length(way);
        float speed = math.min(
            k_Rate * distance, math.min(math.sqrt(situation.limits.Acceleration * distance), 0.9f * situation.limits.TopSpeed));
        float3 velocity = math.normalizesafe(way) * speed;
        velocity.y = math.clamp(k_Rate * way.y, situation.limits.LeastClimb, situation.limits.MostClimb);
        return FlightCommand.Fly(velocity, situation.heading);
    }
}
