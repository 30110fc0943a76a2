using Unity.Mathematics;
using UnityEngine;

namespace Alate.Geometry
{
    /// <summary>Normalises directions that users give.</summary>
    internal static class Directions
    {
        /// <summary>Unit vector along a finite vector that is not zero; neither tiny nor huge vectors lose their direction.</summary>
        public static float3 Unit(Vector3 v)
        {
            float3 a = v;
            return math.normalize(a / math.cmax(math.abs(a)));
        }
    }
}
