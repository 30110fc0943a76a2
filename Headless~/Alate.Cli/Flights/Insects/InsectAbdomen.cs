namespace Alate.Cli;

/// <summary>Abdomen of an insect that swings with the beat.</summary>
internal sealed class InsectAbdomen
{
    private readonly SurfaceMesh m_Body;
    private readonly int m_Start;
    private readonly float m_Swing, m_Lowest;

    private InsectAbdomen(InsectDefinition insect, SurfaceMesh body)
    {
        m_Body = body;
        m_Start = insect.Body.AbdomenStart;
        m_Swing = math.radians(insect.Abdomen.swing);
        m_Lowest = math.radians(insect.Abdomen.lowestPhase);
        Hinge = insect.Abdomen.Hinge;
        Trunk = insect.Body.CreateParts(1f, insect.Abdomen.Hinge, out SurfaceMesh own);
        Surface = own;
    }

    /// <summary>Hinge, from the middle of the thorax, metres.</summary>
    public float3 Hinge { get; }

    /// <summary>The body without it, metres.</summary>
    public SurfaceMesh Trunk { get; }

    /// <summary>The abdomen alone, metres from its hinge.</summary>
    public SurfaceMesh Surface { get; }

    /// <summary>Returns the abdomen of an insect; null where none swings, or its mesh has none of its own.</summary>
    /// <param name="insect">The insect.</param>
    /// <param name="body">Its body, metres.</param>
    public static InsectAbdomen Of(InsectDefinition insect, SurfaceMesh body) =>
        insect.Abdomen.swing == 0f || insect.Body.AbdomenStart == body.VertexCount ? null : new InsectAbdomen(insect, body);

    /// <summary>Evaluates the angle above where it does not swing, radians.</summary>
    /// <param name="turns">Beats.</param>
    /// <param name="flap">Flap of the first wing, from end to end, radians.</param>
    /// <param name="wing">That wing.</param>
    public float AngleAt(double turns, float flap, in WingParameters wing) =>
        BodyAbdomen.AngleAt(BeatingShare.Of(0.5f * flap, wing) * m_Swing, m_Lowest, (float)(2.0 * Math.PI * (turns - Math.Floor(turns))));

    /// <summary>Returns the whole body with the abdomen at an angle.</summary>
    /// <param name="angle">Radians above where it does not swing.</param>
    public (float3[] Positions, float3[] Normals) Pose(float angle)
    {
        var turn = quaternion.RotateX(angle);
        float3[] positions = Array.ConvertAll(m_Body.positions, place => (float3)place),
            normals = Array.ConvertAll(m_Body.normals, normal => (float3)normal);
        for (int vertex = m_Start; vertex < positions.Length; vertex++)
        {
            positions[vertex] = Hinge + math.rotate(turn, positions[vertex] - Hinge);
            normals[vertex] = math.rotate(turn, normals[vertex]);
        }

        return (positions, normals);
    }
}
