namespace Alate.Drawing;

/// <summary>Scene as its sun sees it: what lies in the light, and what in a shadow.</summary>
internal sealed class SunMap
{
    /// <summary>Cells along the longer side.</summary>
    private const int k_Cells = 1536;

    /// <summary>Cells by which a place may lie below what is lit and is lit too.</summary>
    private const float k_Bias = 3f;

    private readonly float3 m_Across, m_Along, m_Towards;
    private readonly float2 m_Low;
    private readonly float m_Cell;
    private readonly int2 m_Size;

    /// <summary>[cell] Height of what is nearest to the sun.</summary>
    private readonly float[] m_Heights;

    /// <param name="surfaces">What there is.</param>
    /// <param name="towards">Direction towards the sun, unit length.</param>
    /// <param name="middle">Position about which there are shadows.</param>
    /// <param name="reach">Distance from there up to which there are some, units of the scene.</param>
    public SunMap(IReadOnlyList<SceneSurface> surfaces, float3 towards, float3 middle, float reach)
    {
        m_Towards = towards;
        m_Across = math.normalize(math.cross(towards, math.abs(towards.z) < 0.9f ? new float3(0f, 0f, 1f) : new float3(1f, 0f, 0f)));
        m_Along = math.cross(towards, m_Across);
        SceneSurface[] casting = [.. surfaces.Where(surface => surface.CastsShadow)];
        float2[][] places = [.. casting.Select(surface => Array.ConvertAll(surface.Places, PlaceOf))];
        float2 low = places.SelectMany(all => all).Aggregate(new float2(float.PositiveInfinity), math.min),
            high = places.SelectMany(all => all).Aggregate(new float2(float.NegativeInfinity), math.max);
        low = math.max(low, PlaceOf(middle) - reach);
        high = math.max(math.min(high, PlaceOf(middle) + reach), low);
        m_Low = low;
        m_Cell = math.max(math.cmax(high - low) / k_Cells, 1e-6f);
        m_Size = (int2)math.floor((high - low) / m_Cell) + 1;
        m_Heights = new float[m_Size.x * m_Size.y];
        Array.Fill(m_Heights, float.NegativeInfinity);
        for (int k = 0; k < places.Length; k++)
            Add(casting[k], Array.ConvertAll(places[k], place => (place - m_Low) / m_Cell));
    }

    /// <summary>Share of the sun's light that reaches a place, 0 to 1.</summary>
    public float At(float3 place)
    {
        var middle = (int2)math.floor((PlaceOf(place) - m_Low) / m_Cell);
        float height = math.dot(place, m_Towards) + k_Bias * m_Cell;
        int lit = 0;
        for (int y = -1; y <= 1; y++)
        {
            for (int x = -1; x <= 1; x++)
            {
                int2 cell = middle + new int2(x, y);
                bool isBeside = math.any(cell < 0) || math.any(cell >= m_Size);
                lit += isBeside || m_Heights[cell.y * m_Size.x + cell.x] <= height ? 1 : 0;
            }
        }

        return lit / 9f;
    }

    private float2 PlaceOf(float3 place) => new(math.dot(place, m_Across), math.dot(place, m_Along));

    private void Add(SceneSurface surface, float2[] cells)
    {
        for (int k = 0; k < surface.Triangles.Length; k += 3)
        {
            (int a, int b, int c) = (surface.Triangles[k], surface.Triangles[k + 1], surface.Triangles[k + 2]);
            var heights = new float3(
                math.dot(surface.Places[a], m_Towards), math.dot(surface.Places[b], m_Towards), math.dot(surface.Places[c], m_Towards));
            TriangleSamples.Visit(cells[a], cells[b], cells[c], (x, y, share) =>
            {
                ref float known = ref m_Heights[y * m_Size.x + x];
                known = math.max(known, math.dot(share, heights));
            }, m_Size);
        }
    }
}
