using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct float2
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
}
