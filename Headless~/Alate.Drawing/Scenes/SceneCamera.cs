namespace Alate.Drawing;

/// <summary>Camera of a scene, with the perspective of a lens that is as wide as its opening.</summary>
internal sealed class SceneCamera
{
    private readonly float3 m_Right, m_Up, m_Ahead;
    private readonly float2 m_Middle;
    private readonly float m_Focus;

    /// <param name="place">Position of the eye, units of the scene.</param>
    /// <param name="turn">From right, up and ahead of the eye to the axes of the scene.</param>
    /// <param name="opening">Degrees from the lower to the upper edge of the picture, above 0 and below 180.</param>
    /// <param name="nearest">Depth before which nothing is seen, units of the scene, above 0.</param>
    /// <param name="size">Columns and rows of the picture.</param>
    public SceneCamera(float3 place, quaternion turn, float opening, float nearest, int2 size)
    {
        Place = place;
        Nearest = nearest;
        Size = size;
        m_Right = math.rotate(turn, new float3(1f, 0f, 0f));
        m_Up = math.rotate(turn, new float3(0f, 1f, 0f));
        m_Ahead = math.rotate(turn, new float3(0f, 0f, 1f));
        m_Middle = 0.5f * (float2)size;
        m_Focus = m_Middle.y / math.tan(math.radians(0.5f * opening));
    }

    /// <summary>Position of the eye, units of the scene.</summary>
    public float3 Place { get; }

    /// <summary>Depth before which nothing is seen, units of the scene.</summary>
    public float Nearest { get; }

    /// <summary>Columns and rows of the picture.</summary>
    public int2 Size { get; }

    /// <summary>Position from the eye: right, up and ahead.</summary>
    public float3 Seen(float3 place)
    {
        float3 way = place - Place;
        return new float3(math.dot(way, m_Right), math.dot(way, m_Up), math.dot(way, m_Ahead));
    }

    /// <summary>Column and row from the upper left corner, pixels, of a position from the eye that lies ahead of it.</summary>
    public float2 Project(float3 seen) => m_Middle + m_Focus / seen.z * new float2(seen.x, -seen.y);
}
