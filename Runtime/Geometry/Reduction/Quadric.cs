using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>Sum of squared distances from planes as a function of the place (Garland and Heckbert 1997).</summary>
    internal struct Quadric
    {
        private double m_Xx, m_Xy, m_Xz, m_Xd, m_Yy, m_Yz, m_Yd, m_Zz, m_Zd, m_Dd;

        /// <summary>Adds a plane n·x + d = 0 of unit normal.</summary>
        public void Add(double x, double y, double z, double d, double weight)
        {
            m_Xx += weight * x * x;
            m_Xy += weight * x * y;
            m_Xz += weight * x * z;
            m_Xd += weight * x * d;
            m_Yy += weight * y * y;
            m_Yz += weight * y * z;
            m_Yd += weight * y * d;
            m_Zz += weight * z * z;
            m_Zd += weight * z * d;
            m_Dd += weight * d * d;
        }

        /// <summary>Adds the squared distance from a point.</summary>
        public void AddPoint(float3 point, double weight)
        {
            Add(1.0, 0.0, 0.0, -point.x, weight);
            Add(0.0, 1.0, 0.0, -point.y, weight);
            Add(0.0, 0.0, 1.0, -point.z, weight);
        }

        /// <summary>Adds another sum.</summary>
        public void Add(in Quadric other)
        {
            m_Xx += other.m_Xx;
            m_Xy += other.m_Xy;
            m_Xz += other.m_Xz;
            m_Xd += other.m_Xd;
            m_Yy += other.m_Yy;
            m_Yz += other.m_Yz;
            m_Yd += other.m_Yd;
            m_Zz += other.m_Zz;
            m_Zd += other.m_Zd;
            m_Dd += other.m_Dd;
        }

        /// <summary>The sum at a place.</summary>
        public double At(float3 place)
        {
            double x = place.x, y = place.y, z = place.z;
            return x * (m_Xx * x + 2 * (m_Xy * y + m_Xz * z + m_Xd)) + y * (m_Yy * y + 2 * (m_Yz * z + m_Yd))
                + z * (m_Zz * z + 2 * m_Zd) + m_Dd;
        }
    }
}
