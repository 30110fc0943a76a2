namespace Alate.Drawing;

/// <summary>The insect at one phase.</summary>
internal sealed class Pose
{
    /// <summary>[surface][vertex] As the camera sees them.</summary>
    public List<float3[]> Places { get; } = [];

    /// <summary>[surface][vertex] As they lie before the camera, metres.</summary>
    public List<float3[]> Points { get; } = [];

    /// <summary>[surface][vertex] On the body.</summary>
    public List<float3[]> Normals { get; } = [];

    /// <summary>Places on the way behind the insect, as the camera sees them.</summary>
    public List<float3> Trail { get; } = [];

    /// <summary>Corners of what is seen of the insect.</summary>
    public (float2 Min, float2 Max) Bounds()
    {
        float2 min = float.PositiveInfinity, max = float.NegativeInfinity;
        foreach (float3[] surface in Places)
        {
            foreach (float3 place in surface)
            {
                min = math.min(min, place.xy);
                max = math.max(max, place.xy);
            }
        }

        return (min, max);
    }
}
