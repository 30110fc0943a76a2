using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Place and attitude of a perch as they were told last, and its motion since then.</summary>
    internal struct PerchFrame
    {
        private float3 m_Normal;
        private float m_Heading;

        /// <param name="position">World units.</param>
        /// <param name="normal">Unit vector out of the surface.</param>
        /// <param name="heading">Radians about the world's up.</param>
        public PerchFrame(float3 position, float3 normal, float heading)
        {
            Position = position;
            m_Normal = normal;
            m_Heading = heading;
        }

        /// <summary>World units.</summary>
        public float3 Position { get; private set; }

        /// <summary>
        /// Moves to where a spot is by now: by the shortest turn from normal to normal, and about the normal by what the heading turns as
        /// seen from above.
        /// </summary>
        /// <param name="spot">A heading that is not a number stays as it was.</param>
        /// <param name="most">World units; what jumps farther is another spot, and takes nothing along.</param>
        /// <param name="from">Where it was, world units.</param>
        /// <param name="turn">Its turn since then.</param>
        /// <returns>True where it has moved and takes along what sits there.</returns>
        public bool Move(in PerchSpot spot, float most, out float3 from, out quaternion turn)
        {
            float3 normal = math.normalizesafe(spot.normal, m_Normal);
            float heading = math.isfinite(spot.heading) ? spot.heading : m_Heading;
            from = Position;
            turn = quaternion.identity;
            if (spot.position.Equals(Position) && normal.Equals(m_Normal) && heading == m_Heading)
                return false;
            float turned = normal.y * Headings.Wrap(heading - m_Heading);
            if (turned != 0f || !normal.Equals(m_Normal))
            {
                var tilt = new quaternion(new float4(math.cross(m_Normal, normal), 1f + math.dot(m_Normal, normal)));
                Elementary.SinCos(0.5f * turned, out float sin, out float cos);
                turn = math.normalizesafe(math.mul(new quaternion(new float4(sin * normal, cos)), tilt));
            }

            Position = spot.position;
            m_Normal = normal;
            m_Heading = heading;
            return math.distance(from, Position) <= most;
        }
    }
}
