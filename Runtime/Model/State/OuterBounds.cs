using Unity.Mathematics;

namespace Alate
{
    /// <summary>Bounds of what comes from outside: far beyond any insect's life, far within what the steps can reckon with.</summary>
    internal static class OuterBounds
    {
        /// <summary>Largest speed of air and bodies along an axis, m/s of the real insect: the air's model knows no shocks.</summary>
        public const float Speed = 1000f;

        /// <summary>Largest turning of a body about an axis, rad/s; of flies that tumble, 200 are known.</summary>
        public const float Turning = 10000f;

        /// <summary>Largest gravity along an axis, m/s².</summary>
        public const float Gravity = 10000f;

        /// <summary>Largest coordinate of a place, world units: floats are a whole unit apart there.</summary>
        public const float Distance = 1e7f;

        /// <summary>Longest time that a wing's beat makes up for, seconds: 30 years.</summary>
        public const float Seconds = 1e9f;

        /// <summary>Returns true where no component is beyond a bound or not a number.</summary>
        public static bool Hold(float3 value, float most) => math.all(math.abs(value) <= most);
    }
}
