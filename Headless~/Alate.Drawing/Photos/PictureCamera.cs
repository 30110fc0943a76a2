namespace Alate.Drawing;

/// <summary>Looks at the body's origin from afar, with a little perspective.</summary>
internal sealed class PictureCamera
{
    private readonly float3 m_Eye, m_Right, m_Up, m_View;

    /// <param name="view">From where it looks.</param>
    /// <param name="distance">Metres from the origin.</param>
    public PictureCamera(PictureView view, float distance)
    {
        math.sincos(math.radians(view.Aside), out float sideSine, out float sideCosine);
        math.sincos(math.radians(view.Above), out float upSine, out float upCosine);
        var towards = new float3(-upCosine * sideSine, upSine, upCosine * sideCosine);
        Distance = distance;
        m_Eye = distance * towards;
        m_View = -towards;
        m_Right = new float3(-sideCosine, 0f, -sideSine);
        m_Up = math.cross(m_View, m_Right);
    }

    /// <summary>From the origin to the eye, metres.</summary>
    public float Distance { get; }

    /// <summary>From the origin to the eye, unit length.</summary>
    public float3 Towards => -m_View;

    /// <summary>A direction given as right, up and towards the viewer, on the body.</summary>
    public float3 Direction(float right, float up, float towards) => math.normalize(right * m_Right + up * m_Up - towards * m_View);

    /// <summary>The place on the body that lies behind one of the plane through the origin, as the eye sees it.</summary>
    /// <param name="seen">x right and y down, metres in that plane.</param>
    /// <param name="distance">Metres from the plane.</param>
    public float3 Behind(float2 seen, float distance) =>
        m_Eye + (1f + distance / Distance) * (seen.x * m_Right - seen.y * m_Up - m_Eye);

    /// <summary>x right and y down, metres in the plane through the origin; z the distance from the eye.</summary>
    public float3 Project(float3 body)
    {
        float3 seen = body - m_Eye;
        float depth = math.dot(seen, m_View);
        float scale = Distance / math.max(depth, 0.1f * Distance);
        return new float3(scale * math.dot(seen, m_Right), -scale * math.dot(seen, m_Up), depth);
    }
}
