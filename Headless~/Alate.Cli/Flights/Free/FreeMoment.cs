using Alate.Flight;

namespace Alate.Cli;

/// <summary>
/// An insect in free flight after one step: SI units, world axes; the moment in body axes. What is wanted is the reference of the feedback,
/// which follows the command of the pilot within what the insect flies.
/// </summary>
internal readonly record struct FreeMoment(
    double Time, float3 Position, quaternion Rotation, float3 Velocity, float3 AngularVelocity, float3 Wanted, float3 Wind, double Phase,
    double Frequency, double Amplitude,
    float3 Force, float3 Moment, double Power, double AidPower, FlightState State)
{
    /// <summary>Velocity that the pilot asked for in this step, m/s.</summary>
    public float3 Commanded { get; init; }

    /// <summary>Heading that it asked for, radians; not a number follows the way.</summary>
    public double CommandedHeading { get; init; } = double.NaN;
}
