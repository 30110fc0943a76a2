using System.Numerics;
using System.Runtime.CompilerServices;

namespace Alate.Benchmarks;

/// <summary>A vertex at rest with the four joints that move it.</summary>
internal struct PlainVertex
{
    /// <summary>In the wing frame, wing lengths.</summary>
    public Vector3 position;

    /// <summary>In the space of the mesh.</summary>
    public Vector3 meshPosition;
    public Vector3 meshNormal;

    public Four<int> joints;
    public Four<float> weights;

    [InlineArray(4)]
    public struct Four<T>
    {
        private T m_First;
    }
}
