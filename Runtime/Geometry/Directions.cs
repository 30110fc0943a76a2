using Unity.Mathematics;
using UnityEngine;

namespace Alate.Geometry
{
    /// <summary>Directions that users give.</summary>
    internal static class Directions
    {
        /// <summary>The unit vector along v, which is finite and not zero; neither tiny nor huge vectors lose their direction.</summary>
        public static float3 Unit(Vector3 v)
        {
            float3 a = v;
            return math.normalize(a / math.cmax(math.abs(a)));
        }
    }
}
