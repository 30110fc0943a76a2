using Alate.Wake;
using Unity.Collections;

namespace Alate.Cli;

/// <summary>Leading and trailing edge of a wing that flies, where the strips of its wake meet.</summary>
internal sealed class WakeGrid
{
    /// <summary>Number of rows of places: the leading and the trailing edge.</summary>
    public const int Edges = 2;

    private readonly WingMount m_Mount;
    private readonly int3[] m_Corners;
    private readonly float3[] m_Shares;

    /// <summary>Finds the edges on the mesh.</summary>
    /// <param name="wing">The wing.</param>
    /// <param name="panels">Strips along the span.</param>
    /// <exception cref="UserException">The mesh has no extent along the span, or a place of it no chord.</exception>
    public WakeGrid(RecordedWing wing, int panels)
    {
        m_Mount = wing.Placement;
        Stations = panels + 1;
        try
        {
            var grid = new SurfaceGrid(wing.Rest, wing.Triangles, Edges, Stations);
            m_Corners = [.. Enumerable.Range(0, Edges * Stations).Select(grid.Corners)];
            m_Shares = [.. Enumerable.Range(0, Edges * Stations).Select(grid.Shares)];
        }
        catch (ArgumentException problem)
        {
            throw new UserException($"This wing sheds no wake. {problem.Message.Split(" (Parameter ")[0]}");
        }
    }

    /// <summary>Number of places along the span, root first.</summary>
    public int Stations { get; }

    /// <summary>Number of places: those of the leading edge, then those of the trailing edge.</summary>
    public int Count => m_Corners.Length;

    /// <summary>Takes the places of a mesh that has just been skinned.</summary>
    /// <param name="vertices">The mesh.</param>
    /// <param name="frame">Frame of the wing in its mesh.</param>
    /// <param name="places">[place] Axes of the body, metres.</param>
    public void Take(NativeArray<SkinnedVertex> vertices, in WingFrame frame, Span<float3> places)
    {
        for (int k = 0; k < places.Length; k++)
        {
            int3 corners = m_Corners[k];
            places[k] = At(k, frame.ToWing(vertices[corners.x].position), frame.ToWing(vertices[corners.y].position),
                frame.ToWing(vertices[corners.z].position));
        }
    }

    /// <summary>Place of the trailing edge on a mesh.</summary>
    /// <param name="station">Place along the span.</param>
    /// <param name="positions">[vertex] Wing frame, wing lengths.</param>
    /// <returns>Axes of the body, metres.</returns>
    public float3 TrailingEdge(int station, float3[] positions)
    {
        int place = Stations + station;
        int3 corners = m_Corners[place];
        return At(place, positions[corners.x], positions[corners.y], positions[corners.z]);
    }

    private float3 At(int place, float3 a, float3 b, float3 c)
    {
        float3 shares = m_Shares[place];
        return m_Mount.ToBody(shares.x * a + shares.y * b + shares.z * c);
    }
}
