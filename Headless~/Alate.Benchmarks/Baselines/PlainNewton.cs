using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>
/// Eq. 12–15 for one wing: Newton with a dense Hessian over all joints that are no roots, factorised by Cholesky in every iteration.
/// </summary>
internal sealed class PlainNewton
{
    private readonly PlainRig m_Rig;
    private readonly float m_Stiffness;
    private readonly int m_Size;
    private readonly int[] m_Rows;
    private readonly float[][] m_Hessian;
    private readonly float[] m_Step;
    private readonly Vector3[] m_Candidate;

    public readonly Vector3[] positions;
    public readonly Vector3[] anchors;
    public readonly float[] inertia;

    public PlainNewton(PlainRig rig, float stiffness)
    {
        m_Rig = rig;
        m_Stiffness = stiffness;
        m_Rows = new int[rig.JointCount];
        for (int joint = 0; joint < m_Rows.Length; joint++)
        {
            m_Rows[joint] = joint % rig.joints == 0 ? -1 : m_Size;
            m_Size += joint % rig.joints == 0 ? 0 : 3;
        }

        m_Hessian = new float[m_Size][];
        for (int row = 0; row < m_Size; row++)
            m_Hessian[row] = new float[m_Size];
        m_Step = new float[m_Size];
        m_Candidate = new Vector3[rig.JointCount];
        positions = new Vector3[rig.JointCount];
        anchors = new Vector3[rig.JointCount];
        inertia = new float[rig.JointCount];
    }

    /// <summary>Minimises from positions, in place.</summary>
    public int Minimise(int iterations, float tolerance)
    {
        for (int k = 1; k <= iterations; k++)
        {
            Assemble(convex: false);
            if (!Factorise())
            {
                Assemble(convex: true);
                Factorise();
            }

            Solve();
            Search();
            float largest = 0f;
            for (int joint = 0; joint < positions.Length; joint++)
                largest = MathF.Max(largest, StepOf(joint).Length());
            if (largest < tolerance)
                return k;
        }

        return iterations;
    }

    private void Assemble(bool convex)
    {
        foreach (float[] row in m_Hessian)
            Array.Clear(row);
        Array.Clear(m_Step);
        for (int joint = 0; joint < positions.Length; joint++)
        {
            AddForce(joint, (positions[joint] - anchors[joint]) * inertia[joint]);
            for (int d = 0; d < 3 && m_Rows[joint] >= 0; d++)
                m_Hessian[m_Rows[joint] + d][m_Rows[joint] + d] += inertia[joint];
        }

        foreach (Spring spring in m_Rig.springs)
        {
            Vector3 difference = positions[spring.a] - positions[spring.b];
            float length = difference.Length();
            Vector3 axis = difference / length;
            Vector3 force = m_Stiffness * (length - spring.length) * axis;
            AddForce(spring.a, force);
            AddForce(spring.b, -force);
            float transversal = 1f - spring.length / length;
            if (convex)
                transversal = MathF.Max(transversal, 0f);
            AddBlock(m_Rows[spring.a], m_Rows[spring.a], axis, m_Stiffness, transversal);
            AddBlock(m_Rows[spring.b], m_Rows[spring.b], axis, m_Stiffness, transversal);
            AddBlock(m_Rows[spring.a], m_Rows[spring.b], axis, -m_Stiffness, transversal);
            AddBlock(m_Rows[spring.b], m_Rows[spring.a], axis, -m_Stiffness, transversal);
        }
    }

    private void AddForce(int joint, Vector3 gradient)
    {
        for (int d = 0; d < 3 && m_Rows[joint] >= 0; d++)
            m_Step[m_Rows[joint] + d] -= gradient[d];
    }

    // k [d dᵀ + (1 − L/l)(I − d dᵀ)]
    private void AddBlock(int row, int column, Vector3 axis, float stiffness, float transversal)
    {
        if (row < 0 || column < 0)
            return;
        for (int r = 0; r < 3; r++)
        {
            for (int c = 0; c < 3; c++)
            {
                float along = axis[r] * axis[c];
                m_Hessian[row + r][column + c] += stiffness * (along + transversal * ((r == c ? 1f : 0f) - along));
            }
        }
    }

    /// <returns>Whether the Hessian is positive definite.</returns>
    private bool Factorise()
    {
        for (int r = 0; r < m_Size; r++)
        {
            float[] row = m_Hessian[r];
            for (int c = 0; c <= r; c++)
            {
                float[] column = m_Hessian[c];
                float sum = row[c];
                for (int k = 0; k < c; k++)
                    sum -= row[k] * column[k];
                if (r == c && sum <= 0f)
                    return false;
                row[c] = r == c ? MathF.Sqrt(sum) : sum / column[c];
            }
        }

        return true;
    }

    private void Solve()
    {
        for (int r = 0; r < m_Size; r++)
        {
            float[] row = m_Hessian[r];
            for (int k = 0; k < r; k++)
                m_Step[r] -= row[k] * m_Step[k];
            m_Step[r] /= row[r];
        }

        for (int r = m_Size - 1; r >= 0; r--)
        {
            for (int k = r + 1; k < m_Size; k++)
                m_Step[r] -= m_Hessian[k][r] * m_Step[k];
            m_Step[r] /= m_Hessian[r][r];
        }
    }

    // Halves the step until the energy falls.
    private void Search()
    {
        float before = Energy(positions);
        for (float length = 1f; length > 1e-3f; length *= 0.5f)
        {
            for (int joint = 0; joint < positions.Length; joint++)
                m_Candidate[joint] = positions[joint] + length * StepOf(joint);
            if (Energy(m_Candidate) <= before * (1f + 1e-6f))
                break;
        }

        Array.Copy(m_Candidate, positions, positions.Length);
    }

    private float Energy(Vector3[] at)
    {
        float sum = 0f;
        for (int joint = 0; joint < at.Length; joint++)
            sum += inertia[joint] * (at[joint] - anchors[joint]).LengthSquared();
        foreach (Spring spring in m_Rig.springs)
        {
            float stretch = (at[spring.a] - at[spring.b]).Length() - spring.length;
            sum += m_Stiffness * stretch * stretch;
        }

        return 0.5f * sum;
    }

    private Vector3 StepOf(int joint)
    {
        int row = m_Rows[joint];
        return row < 0 ? default : new Vector3(m_Step[row], m_Step[row + 1], m_Step[row + 2]);
    }
}
