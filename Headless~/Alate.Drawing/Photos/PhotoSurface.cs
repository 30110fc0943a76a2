namespace Alate.Drawing;

/// <summary>A surface as a photo shows it: shaded and coloured again at every sample.</summary>
internal sealed class PhotoSurface
{
    /// <summary>Half the width of the line around a wing, pixels.</summary>
    private const float k_HalfLine = 0.55f;

    /// <summary>The same of an outline alone.</summary>
    private const float k_HalfOutline = 0.8f;

    /// <summary>Depth of the line around a wing over the wing's own: a little nearer. An outline alone lies before all else.</summary>
    private const float k_Nearer = 0.9985f, k_Before = 0.1f;

    /// <summary>Light of that line over the wing's own.</summary>
    private const float k_LineLight = 0.3f;

    /// <summary>Width over which the colours of a pattern blend in a shadow, wing lengths.</summary>
    private const float k_Blurred = 0.02f;

    /// <summary>Most places of a pattern that are averaged at a sample.</summary>
    private const int k_MostTaps = 12;

    /// <summary>A wing without colours of its own: pale membrane, linear light.</summary>
    private static readonly float4 s_Membrane = new(Shading.ToLinear(new float3(0.84f, 0.79f, 0.66f)), 1f);

    private readonly int m_Index;
    private readonly int[] m_Triangles;
    private readonly float4[] m_Values;
    private readonly Func<float4, float, float4> m_ColourOf;
    private readonly List<MarginEdge> m_Margin;
    private readonly bool m_IsThin, m_HasPattern;
    private readonly float m_HalfLine = k_HalfLine, m_LineDepth = k_Nearer;
    private readonly float4 m_Underside;

    /// <summary>Returns true for values that lie on a wing whose margin is rounder than its mesh; null where the mesh ends it.</summary>
    private readonly Func<float4, bool> m_IsWithin;

    /// <summary>The rim of such a wing, and for each vertex whether it lies on it; null where the mesh ends a wing.</summary>
    private readonly RoundedRim m_Rim;
    private readonly bool[] m_IsRim;

    /// <summary>[vertex] Share of the light that it takes away; null for what casts no shadow.</summary>
    private readonly Lazy<float[]> m_Taken;

    private PhotoSurface(int index, List<MarginEdge> margin, float4[] values)
        : this(index, [], values, (value, _) => value / k_LineLight, true, false, margin)
    {
        m_HalfLine = k_HalfOutline;
        m_LineDepth = k_Before;
    }

    private PhotoSurface(
        int index, int[] triangles, float4[] values, Func<float4, float, float4> colourOf, bool isThin, bool hasPattern,
        List<MarginEdge> margin, float4 underside = default, Func<float4, bool> isWithin = null,
        RoundedRim rim = null)
    {
        m_Underside = underside;
        m_IsWithin = isWithin;
        m_Rim = rim;
        m_IsRim = rim?.Vertices(values.Length);
        m_Index = index;
        m_Triangles = triangles;
        m_Values = values;
        m_ColourOf = colourOf;
        m_IsThin = isThin;
        m_HasPattern = hasPattern;
        m_Margin = margin;
        bool isSolid = triangles.Length > 0 && (!isThin || margin.Count > 0 || rim != null);
        float most = isThin ? 1f - Shading.Through : 1f;
        m_Taken = isSolid ? new Lazy<float[]>(() => Array.ConvertAll(values, value => most * colourOf(value, k_Blurred).w)) : null;
    }

    /// <summary>A body, in the colours of its vertices.</summary>
    public static PhotoSurface Of(SurfaceMesh body) => new(
        0, body.triangles, Array.ConvertAll(body.colours, colour => Shading.Linear(colour)), (colour, _) => colour, false, false, []);

    /// <summary>A thin surface, a wing with a line around it.</summary>
    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="rest">[vertex] Its places at rest.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    /// <param name="values">[vertex] What its colour is made of: a colour, a place in a pattern or a picture, a number.</param>
    /// <param name="colourOf">Linear light and opacity of such a value, over a width in wing lengths; null is a pale membrane.</param>
    /// <param name="hasPattern">True where values are places in something fine.</param>
    /// <param name="hasEdge">False for what is nothing solid, such as moving air: it has no line around it, and no shadow.</param>
    /// <param name="underside">Linear light towards which the lower side is paler, and how far.</param>
    /// <param name="isWithin">
    /// Returns true for values that lie on the wing, whose margin is a smooth curve just inside the rim; null where the mesh ends it.
    /// </param>
    public static PhotoSurface Thin(
        int index, float3[] rest, int[] triangles, float4[] values, Func<float4, float, float4> colourOf, bool hasPattern = false,
        bool hasEdge = true, float4 underside = default, Func<float4, bool> isWithin = null) => new(
            index, triangles, values, colourOf ?? ((_, _) => s_Membrane), true, hasPattern,
            hasEdge && isWithin == null ? MeshMargin.Of(rest, triangles) : [], underside, isWithin,
            isWithin == null ? null : new RoundedRim(rest, triangles));

    /// <summary>The line around a wing alone, before all else.</summary>
    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="rest">[vertex] Places of the wing at rest.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    /// <param name="light">Its linear light.</param>
    public static PhotoSurface Outline(int index, float3[] rest, int[] triangles, float3 light) =>
        new(index, MeshMargin.Of(rest, triangles), Array.ConvertAll(rest, _ => new float4(light, 1f)));

    /// <summary>True where it stands in the way of light; lines alone and moving air do not.</summary>
    public bool CastsShadow => m_Taken != null;

    /// <summary>Surface as it stands in the way of light; null where it does not.</summary>
    /// <param name="points">[vertex] Metres.</param>
    public ShadowCaster Caster(float3[] points) => CastsShadow ? new ShadowCaster(points, m_Triangles, m_Taken.Value) : null;

    /// <summary>Draws the surface.</summary>
    /// <param name="grid">Where to.</param>
    /// <param name="places">[vertex] x and y in samples, z the depth.</param>
    /// <param name="normals">[vertex] Unit vectors on the body.</param>
    /// <param name="shading">The light.</param>
    /// <param name="softness">Width over which the colours of a wing's pattern blend, wing lengths.</param>
    /// <param name="received">
    /// Shares of the key light and of the light from all around at a place of a triangle, by its corners and their shares; null for all.
    /// </param>
    public void Draw(
        SampleGrid grid, float3[] places, float3[] normals, Shading shading, float softness, Func<int3, float3, float2> received = null)
    {
        for (int k = 0; k < m_Triangles.Length; k += 3)
        {
            int3 t = new(m_Triangles[k], m_Triangles[k + 1], m_Triangles[k + 2]);
            (float4 Step, int Count) along = m_HasPattern ? Squeezed(t, places) : (default, 1);
            bool isCut = m_IsWithin != null && (m_IsRim[t.x] || m_IsRim[t.y] || m_IsRim[t.z]);
            TriangleSamples.Visit(places[t.x].xy, places[t.y].xy, places[t.z].xy, (x, y, share) =>
            {
                float depth = math.dot(share, new float3(places[t.x].z, places[t.y].z, places[t.z].z));
                if (!grid.IsSeen(x, y, depth))
                    return;
                float4 value = share.x * m_Values[t.x] + share.y * m_Values[t.y] + share.z * m_Values[t.z];
                if (isCut && !m_IsWithin(value))
                    return;
                float4 colour = Mean(value, along, softness);
                float3 normal = math.normalizesafe(share.x * normals[t.x] + share.y * normals[t.y] + share.z * normals[t.z]);
                float2 lit = received == null ? 1f : received(t, share);
                float3 light = shading.Light(colour.xyz, normal, m_IsThin, lit.x, lit.y, m_Underside);
                grid.Add(x, y, depth, new float4(light, colour.w), m_Index);
            });
        }

        foreach (MarginEdge edge in m_Margin)
        {
            float3 colour = k_LineLight * m_ColourOf(0.5f * (m_Values[edge.A] + m_Values[edge.B]), softness).xyz;
            DrawLine(grid, places[edge.A], places[edge.B], new float4(colour, 1f));
        }

        foreach ((int vertex, float3 from, float3 to) in m_Rim?.Pieces(places) ?? [])
            DrawLine(grid, from, to, new float4(k_LineLight * m_ColourOf(m_Values[vertex], softness).xyz, 1f));
    }

    // The colour over a stretch of the pattern.
    private float4 Mean(float4 value, (float4 Step, int Count) along, float softness)
    {
        if (along.Count == 1)
            return m_ColourOf(value, softness);
        float4 sum = 0f;
        for (int k = 0; k < along.Count; k++)
        {
            float4 colour = m_ColourOf(value + (k - 0.5f * (along.Count - 1)) * along.Step, softness);
            sum += new float4(colour.w * colour.xyz, colour.w);
        }

        return new float4(sum.xyz / math.max(sum.w, 1e-6f), sum.w / along.Count);
    }

    // Of a triangle seen at a slant a pixel holds a long and narrow piece of the pattern: a sample is the mean of its part of it, in steps
    // about as long as the piece is wide.
    private (float4 Step, int Count) Squeezed(int3 t, float3[] places)
    {
        float2 p = places[t.y].xy - places[t.x].xy, q = places[t.z].xy - places[t.x].xy;
        float4 u = m_Values[t.y] - m_Values[t.x], v = m_Values[t.z] - m_Values[t.x];
        float area = p.x * q.y - p.y * q.x;
        if (area == 0f)
            return (default, 1);
        float4 x = (q.y * u - p.y * v) / area, y = (p.x * v - q.x * u) / area;
        float xx = math.dot(x, x), yy = math.dot(y, y), xy = math.dot(x, y), spread = math.sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy);
        float longest = math.sqrt(0.5f * (xx + yy) + spread), narrowest = math.sqrt(math.max(0.5f * (xx + yy) - spread, 0f));
        int count = (int)math.ceil(math.min(longest / math.max(narrowest, 1e-9f), k_MostTaps) / SampleGrid.k_Fineness);
        float turn = 0.5f * math.atan2(2f * xy, xx - yy);
        return count < 2 ? (default, 1) : ((math.cos(turn) * x + math.sin(turn) * y) / count, count);
    }

    // Two triangles, a little nearer than the wing, and beyond both ends so that lines in a row join.
    private void DrawLine(SampleGrid grid, float3 from, float3 to, float4 light)
    {
        float2 along = m_HalfLine * SampleGrid.k_Fineness * math.normalizesafe(to.xy - from.xy), aside = new(-along.y, along.x);
        float2 start = from.xy - 0.5f * along, end = to.xy + 0.5f * along;
        TriangleSamples.Visitor draw = (x, y, _) =>
        {
            float depth = m_LineDepth * math.min(from.z, to.z);
            if (grid.IsSeen(x, y, depth))
                grid.Add(x, y, depth, light, m_Index);
        };
        TriangleSamples.Visit(start - aside, end - aside, end + aside, draw);
        TriangleSamples.Visit(start - aside, end + aside, start + aside, draw);
    }
}
