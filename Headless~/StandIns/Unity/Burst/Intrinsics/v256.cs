using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Unity.Burst.Intrinsics;

/// <summary>Eight single-precision numbers, as a register of 256 bits holds them; the first shares its bytes.</summary>
[StructLayout(LayoutKind.Explicit, Size = 32)]
public struct v256
{
    [FieldOffset(0)] public float Float0;
    [FieldOffset(0)] internal Vector256<float> lanes;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal v256(Vector256<float> lanes)
    {
        Unsafe.SkipInit(out this);
        this.lanes = lanes;
    }
}
