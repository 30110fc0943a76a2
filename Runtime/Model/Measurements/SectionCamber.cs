using Unity.Mathematics;

namespace Alate
{
    /// <summary>Camber of a section: the largest distance of its places from its chord line, over the chord, positive on the dorsal
    /// side.</summary>
    internal static class SectionCamber
    {
        /// <summary>The camber in the given shape, share of the chord.</summary>
        /// <param name="section">The section.</param>
        /// <param name="leadingEdge">Direction of the leading edge, root to tip; it and the chord say which side is dorsal.</param>
        /// <param name="positions">[vertex] Positions of the mesh that was cut.</param>
        public static float Of(WingSection section, float3 leadingEdge, float3[] positions)
        {
            float3 trailing = section.Trailing(positions);
            float3 chord = section.Leading(positions) - trailing;
            float3 dorsal = math.normalizesafe(math.cross(chord, leadingEdge));
            float camber = 0f;
            for (int k = 1; k < section.Count - 1; k++)
            {
                float height = math.dot(section.At(k, positions) - trailing, dorsal);
                camber = math.abs(height) > math.abs(camber) ? height : camber;
            }

            return camber / math.max(math.length(chord), math.FLT_MIN_NORMAL);
        }
    }
}
