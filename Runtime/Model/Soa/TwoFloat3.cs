using System.Runtime.CompilerServices;

namespace Alate
{
    /// <summary>Two <see cref="SoaFloat3"/> side by side, in registers of eight lanes.</summary>
    internal unsafe struct TwoFloat3
    {
        public TwoFloat4 x;
        public TwoFloat4 y;
        public TwoFloat4 z;

        /// <summary>Reads one from each place.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 Load(SoaFloat3* first, SoaFloat3* second) => new TwoFloat3
        {
            x = TwoFloat4.Load(&first->x, &second->x),
            y = TwoFloat4.Load(&first->y, &second->y),
            z = TwoFloat4.Load(&first->z, &second->z),
        };

        /// <summary>Reads one, for both.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 Both(SoaFloat3* value) => new TwoFloat3
        {
            x = TwoFloat4.Both(&value->x),
            y = TwoFloat4.Both(&value->y),
            z = TwoFloat4.Both(&value->z),
        };

        /// <summary>Writes one to each place.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly void Store(SoaFloat3* first, SoaFloat3* second)
        {
            x.Store(&first->x, &second->x);
            y.Store(&first->y, &second->y);
            z.Store(&first->z, &second->z);
        }

        /// <summary>Sum.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 operator +(in TwoFloat3 a, in TwoFloat3 b) => new TwoFloat3 { x = a.x + b.x, y = a.y + b.y, z = a.z + b.z };

        /// <summary>Difference.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 operator -(in TwoFloat3 a, in TwoFloat3 b) => new TwoFloat3 { x = a.x - b.x, y = a.y - b.y, z = a.z - b.z };

        /// <summary>Scaled by one factor a lane.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 operator *(in TwoFloat3 a, TwoFloat4 s) => new TwoFloat3 { x = a.x * s, y = a.y * s, z = a.z * s };

        /// <summary>Outer product.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 Cross(in TwoFloat3 a, in TwoFloat3 b) =>
            new TwoFloat3 { x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x };

        /// <summary>Component by component, as <see cref="TwoFloat4.Lower"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 Lower(in TwoFloat3 a, in TwoFloat3 bound) => new TwoFloat3
        {
            x = TwoFloat4.Lower(a.x, bound.x),
            y = TwoFloat4.Lower(a.y, bound.y),
            z = TwoFloat4.Lower(a.z, bound.z),
        };

        /// <summary>Component by component, as <see cref="TwoFloat4.Higher"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat3 Higher(in TwoFloat3 a, in TwoFloat3 bound) => new TwoFloat3
        {
            x = TwoFloat4.Higher(a.x, bound.x),
            y = TwoFloat4.Higher(a.y, bound.y),
            z = TwoFloat4.Higher(a.z, bound.z),
        };

        /// <summary>Squared length.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 LengthSquared(in TwoFloat3 a) => a.x * a.x + a.y * a.y + a.z * a.z;
    }
}
