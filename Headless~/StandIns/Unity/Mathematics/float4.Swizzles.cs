using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public partial struct float4
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

    public float2 ww
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(w, w);
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

    public float2 zw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(z, w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            z = value.x;
            w = value.y;
        }
    }

    public float2 xw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(x, w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            x = value.x;
            w = value.y;
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

    public float3 yzw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(y, z, w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            y = value.x;
            z = value.y;
            w = value.z;
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

    public float3 www
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(w, w, w);
    }

    public float4 xxxx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(0, 0, 0, 0)));
    }

    public float4 yyyy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(1, 1, 1, 1)));
    }

    public float4 zzzz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(2, 2, 2, 2)));
    }

    public float4 wwww
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(3, 3, 3, 3)));
    }

    public float4 xyzw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => this;
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => this = value;
    }

    public float4 wzyx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(3, 2, 1, 0)));
    }

    public float4 yzxw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(1, 2, 0, 3)));
    }

    public float4 zxyw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(2, 0, 1, 3)));
    }

    public float4 xyxy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(0, 1, 0, 1)));
    }

    public float4 zwzw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(2, 3, 2, 3)));
    }

    public float4 xzyw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(0, 2, 1, 3)));
    }

    public float4 yxwz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(1, 0, 3, 2)));
    }

    public float4 zwxy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(2, 3, 0, 1)));
    }

    public float4 xyzx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(0, 1, 2, 0)));
    }

    public float4 wwwx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(3, 3, 3, 0)));
    }

    public float4 yzxy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(1, 2, 0, 1)));
    }

    public float4 zxyy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(2, 0, 1, 1)));
    }

    public float4 zxyz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(2, 0, 1, 2)));
    }

    public float4 yzxz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128.Shuffle(lanes, Vector128.Create(1, 2, 0, 2)));
    }
}
