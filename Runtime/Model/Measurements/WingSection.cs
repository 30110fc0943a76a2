using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Cut through a wing at one rest span, as places on the edges of its mesh from the leading to the trailing edge. Baked once on the
    /// rest mesh; follows the deformed mesh.
    /// </summary>
    internal sealed class WingSection
    {
        /// <summary>Distance below which two places are one, wing lengths: edges that meet in a vertex on the cut.</summary>
        private const float k_SamePlace = 1e-6f;

        private readonly Place[] m_Places;

        private WingSection(Place[] places)
        {
            m_Places = places;
        }

        /// <summary>Places from leading to trailing edge, two or more.</summary>
        public int Count => m_Places.Length;

        /// <summary>Cuts a wing.</summary>
        /// <param name="rest">[vertex] Rest positions, wing frame, wing lengths.</param>
        /// <param name="triangles">Three vertex indices a triangle.</param>
        /// <param name="span">Where to cut, wing lengths from the hinge.</param>
        /// <exception cref="ArgumentException">The wing has no chord at this span.</exception>
        public static WingSection Cut(float3[] rest, int[] triangles, float span)
        {
            var places = new List<Place>();
            var cut = new MeshEdges();
            for (int corner = 0; corner < triangles.Length; corner++)
            {
                int a = triangles[corner], b = triangles[TriangleLinks.Next(corner)];
                if (rest[a].x < span != rest[b].x < span && cut.Add(a, b))
                    places.Add(new Place(math.min(a, b), math.max(a, b), rest, span));
            }

            places.Sort((one, other) => other.forward.CompareTo(one.forward));
            for (int k = places.Count - 1; k > 0; k--)
            {
                if (places[k - 1].forward - places[k].forward < k_SamePlace)
                    places.RemoveAt(k);
            }

            if (places.Count < 2 || places[0].forward - places[places.Count - 1].forward < k_SamePlace)
                throw new ArgumentException(FormattableString.Invariant($"The wing has no chord at {span} of its span."));
            return new WingSection(places.ToArray());
        }

        /// <summary>A place of the section on a deformed wing; 0 is the leading edge, <see cref="Count"/> − 1 the trailing edge.</summary>
        /// <param name="index">The place.</param>
        /// <param name="positions">[vertex] Positions of the mesh that was cut.</param>
        public float3 At(int index, float3[] positions)
        {
            Place place = m_Places[index];
            return math.lerp(positions[place.a], positions[place.b], place.share);
        }

        /// <summary>The section's place on the leading edge.</summary>
        public float3 Leading(float3[] positions) => At(0, positions);

        /// <summary>The section's place on the trailing edge.</summary>
        public float3 Trailing(float3[] positions) => At(m_Places.Length - 1, positions);

        /// <summary>Vector from the trailing to the leading edge, wing lengths.</summary>
        public float3 Chord(float3[] positions) => Leading(positions) - Trailing(positions);

        private readonly struct Place
        {
            public readonly int a, b;
            public readonly float share;
            public readonly float forward;

            public Place(int a, int b, float3[] rest, float span)
            {
                this.a = a;
                this.b = b;
                share = math.saturate((span - rest[a].x) / (rest[b].x - rest[a].x));
                forward = math.lerp(rest[a].z, rest[b].z, share);
            }
        }
    }
}
