namespace Alate.Cli;

/// <summary>Placement of a wing on the body: X right, Y up, Z ahead, metres from the middle of the thorax.</summary>
/// <param name="Hinge">The hinge of the right wing.</param>
/// <param name="Length">Metres of one wing length.</param>
/// <param name="Side">A left wing is the mirror image.</param>
internal readonly record struct WingMount(float3 Hinge, float Length, WingSide Side)
{
    public bool IsLeft => Side == WingSide.Left;

    /// <summary>A point of the wing frame on the body, metres.</summary>
    public float3 ToBody(float3 wing) => DirectionToBody(Hinge + Length * wing);

    /// <summary>
    /// An axis of turning of the wing frame (a moment) on the body: a mirror image keeps it where it turns a direction round.
    /// </summary>
    public float3 AxisToBody(float3 wing) => IsLeft ? new float3(wing.x, -wing.y, -wing.z) : wing;

    /// <summary>A direction of the wing frame on the body.</summary>
    public float3 DirectionToBody(float3 wing) => IsLeft ? new float3(-wing.x, wing.y, wing.z) : wing;
}
