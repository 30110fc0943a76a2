using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>The insect at one phase.</summary>
internal sealed class Pose
{
    /// <summary>[surface][vertex] As the camera sees them.</summary>
    public List<float3[]> Places { get; } = [];

    /// <summary>[surface][vertex] On the body.</summary>
    public List<float3[]> Normals { get; } = [];
}
