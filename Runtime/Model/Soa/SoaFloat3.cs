using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>One vector of four wings: component-wise, lane = wing. Reads like <see cref="float3"/>.</summary>
    internal struct SoaFloat3
    {
        /// <summary>The x components of the four wings.</summary>
        public float4 x;

        /// <summary>The y components of the four wings.</summary>
        public float4 y;

        /// <summary>The z components of the four wings.</summary>
        public float4 z;

        /// <summary>Three components, each of four wings.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public SoaFloat3(float4 x, float4 y, float4 z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        /// <summary>Vector with equal components in all four wings.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public SoaFloat3(float3 v)
        {
            x = v.x;
            y = v.y;
            z = v.z;
        }

        /// <summary>Sum.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 operator +(in SoaFloat3 a, in SoaFloat3 b) => new SoaFloat3 { x = a.x + b.x, y = a.y + b.y, z = a.z + b.z };

        /// <summary>Difference.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 operator -(in SoaFloat3 a, in SoaFloat3 b) => new SoaFloat3 { x = a.x - b.x, y = a.y - b.y, z = a.z - b.z };

        /// <summary>Opposite.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 operator -(in SoaFloat3 a) => new SoaFloat3 { x = -a.x, y = -a.y, z = -a.z };

        /// <summary>Scaled by one factor per wing.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 operator *(in SoaFloat3 a, float4 s) => new SoaFloat3 { x = a.x * s, y = a.y * s, z = a.z * s };

        /// <summary>Scaled by one factor per wing.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 operator *(float4 s, in SoaFloat3 a) => new SoaFloat3 { x = a.x * s, y = a.y * s, z = a.z * s };

        /// <summary>Inner product.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Dot(in SoaFloat3 a, in SoaFloat3 b) => a.x * b.x + a.y * b.y + a.z * b.z;

        /// <summary>Outer product, formula-wise: X × Y = Z.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Cross(in SoaFloat3 a, in SoaFloat3 b) =>
            new SoaFloat3 { x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x };

        /// <summary>Squared length.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 LengthSquared(in SoaFloat3 a) => a.x * a.x + a.y * a.y + a.z * a.z;

        /// <summary>Unit vector; zero where the length is below 1e-12.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 NormalizeSafe(in SoaFloat3 a) => a * SoaMath.SafeReciprocal(math.sqrt(LengthSquared(a)));

        /// <summary>Per wing: <paramref name="b"/> where <paramref name="test"/> holds, else <paramref name="a"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Select(in SoaFloat3 a, in SoaFloat3 b, bool4 test) =>
            new SoaFloat3 { x = math.select(a.x, b.x, test), y = math.select(a.y, b.y, test), z = math.select(a.z, b.z, test) };

        /// <summary>Each component between two bounds.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Clamp(in SoaFloat3 a, float4 least, float4 most) => new SoaFloat3
        {
            x = math.min(math.max(a.x, least), most),
            y = math.min(math.max(a.y, least), most),
            z = math.min(math.max(a.z, least), most),
        };

        /// <summary>The vector of one wing.</summary>
        public float3 this[int lane]
        {
            get => new float3(x[lane], y[lane], z[lane]);
            set
            {
                x[lane] = value.x;
                y[lane] = value.y;
                z[lane] = value.z;
            }
        }
    }
}
