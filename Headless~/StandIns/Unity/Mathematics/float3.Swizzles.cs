using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct float3
{
    public float2 xx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, x);
    }

    public float2 yy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, y);
    }

    public float2 zz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, z);
    }

    public float2 xy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            x = value.x;
            y = value.y;
        }
    }

    public float2 xz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            x = value.x;
            z = value.y;
        }
    }

    public float2 yx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, x);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            y = value.x;
            x = value.y;
        }
    }

    public float2 yz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            y = value.x;
            z = value.y;
        }
    }

    public float2 zx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, x);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            z = value.x;
            x = value.y;
        }
    }

    public float2 zy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            z = value.x;
            y = value.y;
        }
    }

    public float3 xxx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, x, x);
    }

    public float3 yyy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, y, y);
    }

    public float3 zzz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, z, z);
    }

    public float3 xyz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, y, z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            x = value.x;
            y = value.y;
            z = value.z;
        }
    }

    public float3 xzy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, z, y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            x = value.x;
            z = value.y;
            y = value.z;
        }
    }

    public float3 yxz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, x, z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            y = value.x;
            x = value.y;
            z = value.z;
        }
    }

    public float3 yzx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, z, x);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            y = value.x;
            z = value.y;
            x = value.z;
        }
    }

    public float3 zxy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, x, y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            z = value.x;
            x = value.y;
            y = value.z;
        }
    }

    public float3 zyx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, y, x);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            z = value.x;
            y = value.y;
            x = value.z;
        }
    }
}
