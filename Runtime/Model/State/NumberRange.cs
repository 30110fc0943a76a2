using Unity.Mathematics;

namespace Alate
{
    /// <summary>Clamping of settings that users type.</summary>
    internal static class NumberRange
    {
        /// <summary>The nearest value between two bounds; the default when the value is not a number.</summary>
        public static float Clamp(float value, float least, float most, float none) =>
            math.isnan(value) ? none : math.clamp(value, least, most);
    }
}
