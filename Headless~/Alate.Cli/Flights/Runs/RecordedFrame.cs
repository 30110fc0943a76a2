namespace Alate.Cli;

/// <summary>One wing after one substep, wing frame, wing lengths, radians.</summary>
internal sealed class RecordedFrame
{
    /// <summary>Seconds since the start of the flight.</summary>
    public double Time { get; init; }

    public float Phase { get; init; }

    /// <summary>Rotation that drives the root of the leading edge.</summary>
    public quaternion Root { get; init; }

    /// <summary>[vertex]</summary>
    public float3[] Positions { get; init; }

    /// <summary>[vertex]</summary>
    public float3[] Normals { get; init; }

    /// <summary>[chain · m + joint]</summary>
    public float3[] Joints { get; init; }

    /// <summary>[chain · (m − 1) + bone] x up, y in the plane, z torsion.</summary>
    public float3[] Bends { get; init; }

    /// <summary>Aerodynamic force, wing masses · L/s².</summary>
    public float3 AirForce { get; init; }

    /// <summary>Moment of the air force about the middle of the thorax, wing masses · L²/s².</summary>
    public float3 AirMoment { get; init; }

    /// <summary>
    /// [chain · m + joint] Force of the air on each joint in this substep, wing masses · L/s²; null where the plan records no air.
    /// </summary>
    public float3[] AirLoads { get; init; }

    /// <summary>Mean angle of attack about 0.75 of the span, radians; only with <see cref="AirLoads"/>.</summary>
    public float Attack { get; init; }

    /// <summary>Strips of the wing, from the hinge; only with <see cref="AirLoads"/>.</summary>
    public SpanStrip[] Strips { get; init; }

    /// <summary>Powers in the substep.</summary>
    public WingPower Power { get; init; }

    public float NewtonIterations { get; init; }
}
