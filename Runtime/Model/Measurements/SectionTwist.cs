using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Twist of a wing: the angle from the chord of an inner section to that of an outer one about the leading edge, positive with the
    /// outer one nose-down as in feathering. The leading edge is the straight line between the leading places of the two deformed sections,
    /// so a wing that turns as a whole, about whatever axis, has no twist.
    /// </summary>
    internal static class SectionTwist
    {
        /// <summary>The angle in the given shape, radians, −π to π; a wing whose rest shape is twisted has one at rest.</summary>
        /// <param name="inner">Section near the root.</param>
        /// <param name="outer">Section near the tip.</param>
        /// <param name="positions">[vertex] Positions of the mesh that was cut.</param>
        public static float Angle(WingSection inner, WingSection outer, float3[] positions)
        {
            float3 edge = LeadingEdge(inner, outer, positions);
            float3 from = Across(inner.Chord(positions), edge);
            float3 to = Across(outer.Chord(positions), edge);
            return Elementary.Atan2(math.dot(math.cross(from, to), edge), math.dot(from, to));
        }

        /// <summary>Unit vector along the leading edge, from the inner to the outer section.</summary>
        public static float3 LeadingEdge(WingSection inner, WingSection outer, float3[] positions) =>
            math.normalizesafe(outer.Leading(positions) - inner.Leading(positions), new float3(1f, 0f, 0f));

        private static float3 Across(float3 chord, float3 edge) => chord - math.dot(chord, edge) * edge;
    }
}
