using Unity.Mathematics;

namespace Alate
{
    /// <summary>A symmetric positive 6×6 matrix of force and moment against velocity and angular velocity: upper triangle row by row.</summary>
    internal unsafe struct Symmetric6
    {
        private fixed float m_Entries[LaneAir.Entries];

        public float this[int entry]
        {
            get => m_Entries[entry];
            set => m_Entries[entry] = value;
        }

        /// <summary>Index of an entry.</summary>
        public static int At(int row, int column) => row <= column ? row * 6 - row * (row - 1) / 2 + column - row : At(column, row);

        /// <summary>Matrix times a vector.</summary>
        public void Multiply(float3 u, float3 w, out float3 force, out float3 moment)
        {
            float* x = stackalloc float[6];
            float* y = stackalloc float[6];
            Split(x, u, w);
            for (int i = 0; i < 6; i++)
            {
                float sum = 0f;
                for (int j = 0; j < 6; j++)
                    sum += m_Entries[At(i, j)] * x[j];
                y[i] = sum;
            }

            force = new float3(y[0], y[1], y[2]);
            moment = new float3(y[3], y[4], y[5]);
        }

        /// <summary>Solves for the vector that the matrix makes into force and moment, by Cholesky.</summary>
        public void Solve(float3 force, float3 moment, out float3 u, out float3 w)
        {
            float* l = stackalloc float[36];
            float* x = stackalloc float[6];
            Split(x, force, moment);
            for (int i = 0; i < 6; i++)
            {
                for (int j = 0; j <= i; j++)
                {
                    float sum = m_Entries[At(i, j)];
                    for (int k = 0; k < j; k++)
                        sum -= l[6 * i + k] * l[6 * j + k];
                    l[6 * i + j] = i == j ? math.sqrt(math.max(sum, 1e-30f)) : sum / l[6 * j + j];
                }
            }

            for (int i = 0; i < 6; i++)
            {
                for (int k = 0; k < i; k++)
                    x[i] -= l[6 * i + k] * x[k];
                x[i] /= l[6 * i + i];
            }

            for (int i = 5; i >= 0; i--)
            {
                for (int k = i + 1; k < 6; k++)
                    x[i] -= l[6 * k + i] * x[k];
                x[i] /= l[6 * i + i];
            }

            u = new float3(x[0], x[1], x[2]);
            w = new float3(x[3], x[4], x[5]);
        }

        private static void Split(float* x, float3 u, float3 w)
        {
            x[0] = u.x;
            x[1] = u.y;
            x[2] = u.z;
            x[3] = w.x;
            x[4] = w.y;
            x[5] = w.z;
        }
    }
}
