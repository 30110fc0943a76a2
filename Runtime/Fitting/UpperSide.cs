using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Fitting
{
    /// <summary>
    /// Chooses which side of a wing is up: the side of a given direction; else the side towards +Y; else, for an upright wing, the side
    /// of its triangles' front.
    /// </summary>
    internal static class UpperSide
    {
        /// <summary>Cosine between the normal and a direction below which the direction does not tell the sides apart.</summary>
        private const float k_Sideways = 0.17f;

        /// <summary>Share of the area by which fronts must outweigh backs.</summary>
        private const float k_Balance = 0.2f;

        /// <summary>The normal or its opposite; the confidence, 0 to 1, is below 1 where neither a direction nor +Y decided.</summary>
        public static float3 Choose(Vector3? given, float3 normal, float3[] points, IReadOnlyList<int3> triangles, out float confidence)
        {
            confidence = 1f;
            float3 wanted = Directions.Unit(given ?? Vector3.up);
            float cosine = math.dot(normal, wanted);
            if (math.abs(cosine) > k_Sideways)
                return cosine > 0f ? normal : -normal;

            float fronts = 0f, area = 0f;
            foreach (int3 t in triangles)
            {
                float3 facing = math.cross(points[t.y] - points[t.x], points[t.z] - points[t.x]);
                fronts += math.dot(facing, normal);
                area += math.length(facing);
            }

            confidence = math.abs(fronts) > k_Balance * area ? 0.8f : 0.5f;
            return fronts >= 0f ? normal : -normal;
        }
    }
}
