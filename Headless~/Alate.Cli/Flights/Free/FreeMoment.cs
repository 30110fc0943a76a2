using Alate.Flight;

namespace Alate.Cli;

/// <summary>An insect in free flight after one step: SI units, world axes; the moment in body axes.</summary>
internal readonly record struct FreeMoment(
    double Time, float3 Position, quaternion Rotation, float3 Velocity, float3 AngularVelocity, float3 Wanted, float3 Wind, double Phase,
    double Frequency, double Amplitude,
    float3 Force, float3 Moment, double Power, double AidPower, FlightState State);
