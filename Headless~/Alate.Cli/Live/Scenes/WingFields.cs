namespace Alate.Cli;

/// <summary>Fields on the mesh of one wing: its stretch, and the angle at which it meets the air.</summary>
internal sealed class WingFields
{
    private readonly StretchField m_Stretch;
    private readonly int[] m_PatchOf;

    /// <param name="wing">A wing without frames.</param>
    public WingFields(RecordedWing wing)
    {
        m_Stretch = new StretchField(wing);
        m_PatchOf = new int[wing.Rest.Length];
        Array.Fill(m_PatchOf, -1);
    }

    /// <summary>Largest |l/l₀ − 1| of the edges that meet at each vertex.</summary>
    /// <param name="positions">[vertex] Wing lengths.</param>
    public float[] Strain(float3[] positions) => m_Stretch.Of(positions);

    /// <summary>Angle of attack of the patch that is nearest to a vertex, radians; 0 before the first step.</summary>
    /// <param name="reading">The wing.</param>
    /// <param name="vertex">The vertex.</param>
    /// <param name="positions">[vertex] As the reading's last step ended, wing lengths.</param>
    public float Attack(in WingReading reading, int vertex, float3[] positions)
    {
        if (!reading.HasPatchLoads || reading.Substeps == 0)
            return 0f;
        if (m_PatchOf[vertex] < 0)
            m_PatchOf[vertex] = Nearest(reading, positions[vertex]);
        return reading.PatchAngleOfAttack(m_PatchOf[vertex]);
    }

    private static int Nearest(in WingReading reading, float3 place)
    {
        int nearest = 0;
        float least = float.PositiveInfinity;
        for (int patch = 0; patch < reading.PatchCount; patch++)
        {
            float distance = math.distancesq(reading.PatchPosition(patch), place);
            (nearest, least) = distance < least ? (patch, distance) : (nearest, least);
        }

        return nearest;
    }
}
