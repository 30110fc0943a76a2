using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// Number made of the bits of others, by Fowler, Noll and Vo's way 1a with 64 bits: another bit anywhere gives another number.
/// </summary>
internal struct BitHash
{
    private const ulong k_Offset = 14695981039346656037, k_Prime = 1099511628211;

    private ulong m_Value;

    /// <summary>Hash of nothing.</summary>
    public static BitHash Empty => new() { m_Value = k_Offset };

    /// <summary>Hash so far.</summary>
    public readonly ulong Value => m_Value;

    /// <summary>Takes in numbers, byte by byte.</summary>
    public void Add<T>(ReadOnlySpan<T> values) where T : unmanaged
    {
        foreach (byte part in MemoryMarshal.AsBytes(values))
            m_Value = (m_Value ^ part) * k_Prime;
    }

    /// <summary>Takes in a number.</summary>
    public void Add(float value) => Add<float>([value]);

    /// <summary>Takes in a vector.</summary>
    public void Add(float3 value) => Add<float>([value.x, value.y, value.z]);

    /// <summary>Takes in a rotation.</summary>
    public void Add(quaternion value) => Add<float>([value.value.x, value.value.y, value.value.z, value.value.w]);

    /// <summary>Takes in another hash.</summary>
    public void Add(ulong value) => Add<ulong>([value]);

    /// <summary>Takes in a wing: its beat, joints and forces.</summary>
    public void Add(in WingReading wing)
    {
        Add(wing.Phase);
        Add(wing.AirForce);
        Add(wing.AirMoment);
        for (int chain = 0; chain < wing.ChainCount; chain++)
        {
            for (int joint = 0; joint < wing.JointsPerChain; joint++)
            {
                Add(wing.JointPosition(chain, joint));
                Add(wing.JointRotation(chain, joint));
            }
        }
    }

    /// <summary>Takes in a body.</summary>
    public void Add(in FlyingBody body)
    {
        Add(body.position);
        Add(body.rotation);
        Add(body.velocity);
        Add(body.spin);
    }
}
