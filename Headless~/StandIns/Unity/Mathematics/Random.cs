using System;
using System.Diagnostics;

namespace Unity.Mathematics;

/// <summary>Xorshift with a period of 2^32 - 1, as Unity's: equal seeds give equal numbers there and here.</summary>
public struct Random
{
    public uint state;

    public Random(uint seed)
    {
        state = seed;
        CheckState();
        NextState();
    }

    /// <summary>Makes a generator from a seed that may count up from 0.</summary>
    public static Random CreateFromIndex(uint index) => new(WangHash(index + 62u));

    public void InitState(uint seed = 0x6E624EB7u)
    {
        state = seed;
        CheckState();
        NextState();
    }

    public bool NextBool() => (NextState() & 1u) == 1u;

    public int NextInt() => (int)NextState() ^ int.MinValue;

    /// <summary>From 0 to max, without max.</summary>
    public int NextInt(int max) => (int)((NextState() * (ulong)max) >> 32);

    /// <summary>From min to max, without max.</summary>
    public int NextInt(int min, int max) => (int)((NextState() * (ulong)(uint)(max - min)) >> 32) + min;

    public uint NextUInt() => NextState() - 1u;

    public uint NextUInt(uint max) => (uint)((NextState() * (ulong)max) >> 32);

    public uint NextUInt(uint min, uint max) => (uint)((NextState() * (ulong)(max - min)) >> 32) + min;

    public float NextFloat() => math.asfloat(0x3f800000u | (NextState() >> 9)) - 1f;

    public float NextFloat(float max) => NextFloat() * max;

    public float NextFloat(float min, float max) => NextFloat() * (max - min) + min;

    public float2 NextFloat2() => new(NextFloat(), NextFloat());

    public float2 NextFloat2(float2 max) => NextFloat2() * max;

    public float2 NextFloat2(float2 min, float2 max) => NextFloat2() * (max - min) + min;

    public float3 NextFloat3() => new(NextFloat(), NextFloat(), NextFloat());

    public float3 NextFloat3(float3 max) => NextFloat3() * max;

    public float3 NextFloat3(float3 min, float3 max) => NextFloat3() * (max - min) + min;

    public float4 NextFloat4() => new(NextFloat(), NextFloat(), NextFloat(), NextFloat());

    public float4 NextFloat4(float4 max) => NextFloat4() * max;

    public float4 NextFloat4(float4 min, float4 max) => NextFloat4() * (max - min) + min;

    public double NextDouble() =>
        BitConverter.UInt64BitsToDouble(0x3ff0000000000000ul | ((ulong)NextState() << 20) ^ NextState()) - 1.0;

    /// <summary>A unit vector.</summary>
    public float2 NextFloat2Direction()
    {
        math.sincos(NextFloat() * math.PI * 2f, out float sine, out float cosine);
        return new float2(cosine, sine);
    }

    /// <summary>A unit vector.</summary>
    public float3 NextFloat3Direction()
    {
        float2 random = NextFloat2();
        float z = random.x * 2f - 1f;
        float r = math.sqrt(math.max(1f - z * z, 0f));
        math.sincos(random.y * math.PI * 2f, out float sine, out float cosine);
        return new float3(cosine * r, sine * r, z);
    }

    /// <summary>A unit quaternion.</summary>
    public quaternion NextQuaternionRotation()
    {
        float3 random = NextFloat3(new float3(2f * math.PI, 2f * math.PI, 1f));
        float i = math.sqrt(1f - random.z), j = math.sqrt(random.z);
        math.sincos(random.xy, out float2 sine, out float2 cosine);
        float4 q = new(i * sine.x, i * cosine.x, j * sine.y, j * cosine.y);
        return new quaternion(math.select(q, -q, q.w < 0f));
    }

    private uint NextState()
    {
        CheckState();
        uint before = state;
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        return before;
    }

    private static uint WangHash(uint n)
    {
        n = (n ^ 61u) ^ (n >> 16);
        n *= 9u;
        n ^= n >> 4;
        n *= 0x27d4eb2du;
        return n ^ (n >> 15);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    private readonly void CheckState()
    {
        if (state == 0)
            throw new ArgumentException("The state of a Random must not be zero: give it a seed other than 0.");
    }
}
