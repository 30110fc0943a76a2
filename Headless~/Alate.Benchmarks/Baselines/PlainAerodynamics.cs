using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>
/// Eq. 9–11 for every triangle of one wing, with the coefficients of Dickinson 1999; loads go to vertices, then to joints.
/// </summary>
internal sealed class PlainAerodynamics
{
    private const float k_Degrees = 180f / MathF.PI;

    private readonly PlainRig m_Rig;
    private readonly float m_HalfDensity;

    // The span axis of a triangle at rest in terms of its two edges.
    private readonly Vector2[] m_Span;
    private readonly Vector3[] m_VertexForces;
    private readonly float[] m_VertexDamping;

    /// <summary>Per joint.</summary>
    public readonly Vector3[] forces;
    public readonly float[] damping;

    public PlainAerodynamics(PlainRig rig, in WingParameters parameters)
    {
        m_Rig = rig;
        m_HalfDensity = 0.5f * parameters.airDensity;
        m_Span = new Vector2[rig.triangles.Length / 3];
        m_VertexForces = new Vector3[rig.vertices.Length];
        m_VertexDamping = new float[rig.vertices.Length];
        forces = new Vector3[rig.JointCount];
        damping = new float[rig.JointCount];
        for (int t = 0; t < m_Span.Length; t++)
            m_Span[t] = SpanInEdges(t);
    }

    /// <summary>Returns the force on the whole wing.</summary>
    public Vector3 Apply(Vector3[] positions, Vector3[] velocities, Vector3 wind)
    {
        Array.Clear(m_VertexForces);
        Array.Clear(m_VertexDamping);
        for (int t = 0; t < m_Span.Length; t++)
            Triangle(t, positions, velocities, wind);
        return ToJoints();
    }

    private void Triangle(int t, Vector3[] positions, Vector3[] velocities, Vector3 wind)
    {
        int a = m_Rig.triangles[3 * t], b = m_Rig.triangles[3 * t + 1], c = m_Rig.triangles[3 * t + 2];
        Vector3 ab = positions[b] - positions[a], ac = positions[c] - positions[a];
        var normal = Vector3.Cross(ab, ac);
        float doubleArea = normal.Length();
        if (doubleArea < 1e-12f)
            return;
        normal /= doubleArea;

        Vector3 air = wind - (velocities[a] + velocities[b] + velocities[c]) / 3f;
        var span = Vector3.Normalize(ab * m_Span[t].X + ac * m_Span[t].Y);
        air -= span * Vector3.Dot(air, span);
        float speed = air.Length();
        if (speed < 1e-6f)
            return;

        float across = Vector3.Dot(air, normal);
        float along = (air - across * normal).Length();
        float angle = (float)Math.Atan2(MathF.Abs(across), along) * k_Degrees;
        float lift = 0.225f + 1.58f * MathF.Sin((2.13f * angle - 7.20f) / k_Degrees);
        float drag = 1.92f - 1.55f * MathF.Cos((2.04f * angle - 9.82f) / k_Degrees);
        Vector3 direction = air / speed;
        float pressure = m_HalfDensity * 0.5f * doubleArea * speed * speed;
        Vector3 force = pressure * drag * direction;
        Vector3 up = normal - direction * Vector3.Dot(normal, direction);
        if (up.Length() > 1e-6f)
            force += pressure * lift * MathF.Sign(across) * Vector3.Normalize(up);

        float sine = MathF.Max(MathF.Abs(across) / speed, 0.05f);
        float resistance = (1f + sine * sine) * (pressure / speed)
            * MathF.Max(0f, lift * along / speed + drag * sine) / sine;
        Add(a, force, resistance);
        Add(b, force, resistance);
        Add(c, force, resistance);
    }

    private void Add(int vertex, Vector3 force, float resistance)
    {
        m_VertexForces[vertex] += force / 3f;
        m_VertexDamping[vertex] += resistance / 3f;
    }

    private Vector3 ToJoints()
    {
        Array.Clear(forces);
        Array.Clear(damping);
        Vector3 total = default;
        for (int v = 0; v < m_VertexForces.Length; v++)
        {
            ref readonly PlainVertex vertex = ref m_Rig.vertices[v];
            total += m_VertexForces[v];
            for (int k = 0; k < 4; k++)
            {
                forces[vertex.joints[k]] += vertex.weights[k] * m_VertexForces[v];
                damping[vertex.joints[k]] += vertex.weights[k] * m_VertexDamping[v];
            }
        }

        return total;
    }

    private Vector2 SpanInEdges(int t)
    {
        Vector3 origin = m_Rig.vertices[m_Rig.triangles[3 * t]].position;
        Vector3 ab = m_Rig.vertices[m_Rig.triangles[3 * t + 1]].position - origin;
        Vector3 ac = m_Rig.vertices[m_Rig.triangles[3 * t + 2]].position - origin;
        float determinant = ab.X * ac.Z - ac.X * ab.Z;
        return determinant == 0f ? Vector2.UnitX : new Vector2(ac.Z, -ab.Z) / determinant;
    }
}
