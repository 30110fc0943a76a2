using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct int4
{
    public int2 xy
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

    public int2 xz
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

    public int2 yz
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

    public int2 zw
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

    public int3 xyz
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
}
