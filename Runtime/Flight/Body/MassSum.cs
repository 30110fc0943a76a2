using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Sums masses to a total, a centre and an inertia, in double precision.</summary>
    internal sealed class MassSum
    {
        private readonly double[] m_First = new double[3];
        private readonly double[,] m_Second = new double[3, 3];

        /// <summary>Kilograms so far.</summary>
        public double Mass { get; private set; }

        /// <summary>Adds an ellipsoid of even density; half axes of 0 are a point.</summary>
        public void Add(double mass, float3 at, float3 halfAxes)
        {
            Mass += mass;
            for (int i = 0; i < 3; i++)
            {
                m_First[i] += mass * at[i];
                for (int j = 0; j < 3; j++)
                    m_Second[i, j] += mass * at[i] * at[j];
                m_Second[i, i] += mass * halfAxes[i] * halfAxes[i] / 5.0;
            }
        }

        /// <summary>Adds another sum, moved from its own axes to these.</summary>
        /// <param name="mass">What the other sum's masses are multiplied by.</param>
        /// <param name="other">The sum.</param>
        /// <param name="axes">Its axes in these, with their scale.</param>
        /// <param name="at">Its origin in these.</param>
        public void Add(double mass, MassSum other, float3x3 axes, float3 at)
        {
            double[] first = new double[3];
            for (int i = 0; i < 3; i++)
            {
                for (int k = 0; k < 3; k++)
                    first[i] += axes[k][i] * other.m_First[k];
            }

            for (int i = 0; i < 3; i++)
            {
                for (int j = 0; j < 3; j++)
                {
                    double second = first[i] * at[j] + at[i] * first[j] + other.Mass * at[i] * at[j];
                    for (int k = 0; k < 3; k++)
                    {
                        for (int l = 0; l < 3; l++)
                            second += axes[k][i] * other.m_Second[k, l] * axes[l][j];
                    }

                    m_Second[i, j] += mass * second;
                }

                m_First[i] += mass * (first[i] + other.Mass * at[i]);
            }

            Mass += mass * other.Mass;
        }

        /// <summary>Centre of mass.</summary>
        public float3 Centre => new float3((float)(m_First[0] / Mass), (float)(m_First[1] / Mass), (float)(m_First[2] / Mass));

        /// <summary>Inertia about the centre of mass.</summary>
        public float3x3 Inertia => InertiaAbout(m_First[0] / Mass, m_First[1] / Mass, m_First[2] / Mass);

        /// <summary>Masses about a point, which do not move.</summary>
        public BodyMasses About(float3 point)
        {
            float3 first = default;
            for (int i = 0; i < 3; i++)
                first[i] = (float)(m_First[i] - Mass * point[i]);
            return new BodyMasses { first = first, inertia = InertiaAbout(point.x, point.y, point.z) };
        }

        private float3x3 InertiaAbout(params double[] point)
        {
            double[,] second = new double[3, 3];
            double trace = 0.0;
            for (int i = 0; i < 3; i++)
            {
                for (int j = 0; j < 3; j++)
                    second[i, j] = m_Second[i, j] - m_First[i] * point[j] - point[i] * m_First[j] + Mass * point[i] * point[j];
                trace += second[i, i];
            }

            float3x3 inertia = default;
            for (int j = 0; j < 3; j++)
            {
                float3 column = default;
                for (int i = 0; i < 3; i++)
                    column[i] = (float)((i == j ? trace : 0.0) - second[i, j]);
                inertia[j] = column;
            }

            return inertia;
        }
    }
}
