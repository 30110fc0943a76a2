using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Grid of places on the mesh of a wing: sections across the span from the leading to the trailing edge, root first. Places are kept as
    /// shares of the corners of a triangle, so that they go with the skinned mesh.
    /// </summary>
    public sealed class SurfaceGrid
    {
        /// <summary>Share of the span that is left out at root and tip, where a section has no chord.</summary>
        private const float k_Margin = 0.005f;

        private readonly int3[] m_Corners;
        private readonly float3[] m_Shares;

        /// <summary>Lays a grid on a wing at rest.</summary>
        /// <param name="rest">[vertex] Frame of the wing: X from root to tip, Z towards the leading edge.</param>
        /// <param name="triangles">Three vertices a triangle.</param>
        /// <param name="across">Places of a section, 2 or more.</param>
        /// <param name="along">Sections, 2 or more.</param>
        /// <exception cref="ArgumentException">The mesh has no extent along the span, or a section without a chord.</exception>
        public SurfaceGrid(IReadOnlyList<float3> rest, IReadOnlyList<int> triangles, int across = 9, int along = 33)
        {
            Across = across;
            Along = along;
            m_Corners = new int3[across * along];
            m_Shares = new float3[across * along];
            float low = float.PositiveInfinity, high = float.NegativeInfinity;
            foreach (int vertex in triangles)
            {
                low = math.min(low, rest[vertex].x);
                high = math.max(high, rest[vertex].x);
            }

            if (!(high - low > 1e-6f) || math.isinf(high - low))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"The wing reaches from {low} to {high} along its span."), nameof(rest));
            }
            for (int j = 0; j < along; j++)
            {
                float span = math.lerp(low, high, math.lerp(k_Margin, 1f - k_Margin, (float)j / (along - 1)));
                float2 edges = Section(rest, triangles, span);
                for (int i = 0; i < across; i++)
                    Attach(rest, triangles, i * along + j, new float2(span, math.lerp(edges.x, edges.y, (float)i / (across - 1))));
            }
        }

        /// <summary>Number of places of a section, leading edge first.</summary>
        public int Across { get; }

        /// <summary>Number of sections, root first.</summary>
        public int Along { get; }

        /// <summary>Corners of the triangle on which a place lies; the index is that of <see cref="Evaluate"/>.</summary>
        internal int3 Corners(int place) => m_Corners[place];

        /// <summary>Shares of those corners in the place.</summary>
        internal float3 Shares(int place) => m_Shares[place];

        /// <summary>Places on the moved mesh.</summary>
        /// <param name="positions">[vertex] Positions.</param>
        /// <returns>[place of the section · sections + section] As chains and joints of <see cref="FourierMotion"/>.</returns>
        public float3[] Evaluate(IReadOnlyList<float3> positions)
        {
            var places = new float3[m_Corners.Length];
            for (int k = 0; k < places.Length; k++)
            {
                int3 corners = m_Corners[k];
                float3 shares = m_Shares[k];
                places[k] = shares.x * positions[corners.x] + shares.y * positions[corners.y] + shares.z * positions[corners.z];
            }

            return places;
        }

        // Leading and trailing edge where the span has a value.
        private static float2 Section(IReadOnlyList<float3> rest, IReadOnlyList<int> triangles, float span)
        {
            float leading = float.NegativeInfinity, trailing = float.PositiveInfinity;
            for (int k = 0; k < triangles.Count; k++)
            {
                float3 a = rest[triangles[k]], b = rest[triangles[k % 3 == 2 ? k - 2 : k + 1]];
                if (a.x < span == b.x < span)
                    continue;
                float z = math.lerp(a.z, b.z, (span - a.x) / (b.x - a.x));
                leading = math.max(leading, z);
                trailing = math.min(trailing, z);
            }

            if (!(leading - trailing > 0f))
                throw new ArgumentException(FormattableString.Invariant($"The wing has no chord at {span} of its span."), nameof(rest));
            return new float2(leading, trailing);
        }

        // The triangle that holds the place, or the nearest: between two lobes of an outline there is none.
        private void Attach(IReadOnlyList<float3> rest, IReadOnlyList<int> triangles, int index, float2 place)
        {
            float nearest = float.PositiveInfinity;
            for (int k = 0; k < triangles.Count && nearest > 0f; k += 3)
            {
                var corners = new int3(triangles[k], triangles[k + 1], triangles[k + 2]);
                float3 shares = Shares(rest[corners.x].xz, rest[corners.y].xz, rest[corners.z].xz, place);
                float outside = math.max(0f, -math.cmin(shares));
                if (!(outside < nearest))
                    continue;
                nearest = outside;
                m_Corners[index] = corners;
                shares = math.max(shares, 0f);
                m_Shares[index] = shares / math.csum(shares);
            }
        }

        private static float3 Shares(float2 a, float2 b, float2 c, float2 p)
        {
            float2 ab = b - a, ac = c - a, ap = p - a;
            float area = ab.x * ac.y - ab.y * ac.x;
            float v = (ap.x * ac.y - ap.y * ac.x) / area, w = (ab.x * ap.y - ab.y * ap.x) / area;
            return new float3(1f - v - w, v, w);
        }
    }
}
