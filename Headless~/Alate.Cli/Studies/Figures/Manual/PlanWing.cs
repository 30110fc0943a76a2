using Alate.Geometry;

namespace Alate.Cli;

/// <summary>A right wing at rest, from above: x along the span, y towards the trailing edge, metres on the body.</summary>
/// <param name="Margins">Closed lines around its mesh.</param>
/// <param name="Chains">Joints of the skeleton, from the leading edge on, each chain from its root.</param>
internal sealed record PlanWing(List<List<float2>> Margins, List<List<float2>> Chains)
{
    /// <summary>All places.</summary>
    public IEnumerable<float2> Places => Margins.Concat(Chains).SelectMany(line => line);

    /// <summary>Map from places of some wings, which together fill a rectangle, to a drawing.</summary>
    /// <param name="wings">The wings.</param>
    /// <param name="middle">Middle of the rectangle.</param>
    /// <param name="size">Its sides.</param>
    public static Func<float2, float2> Fit(IReadOnlyList<PlanWing> wings, float2 middle, float2 size)
    {
        float2 least = wings.SelectMany(wing => wing.Places).Aggregate(math.min),
            most = wings.SelectMany(wing => wing.Places).Aggregate(math.max);
        float scale = math.cmin(size / (most - least));
        return place => middle + scale * (place - 0.5f * (least + most));
    }

    /// <summary>A wing of the catalogue.</summary>
    public static PlanWing Of(InsectWing wing)
    {
        float2 From(float3 place) => new float2(place.x, -place.z) / InsectDefinition.UnitsPerMetre
            + (wing.Origin is { } origin ? new float2(origin.x, -origin.z) : 0f);
        float3[] rest = Array.ConvertAll(wing.Surface.positions, place => (float3)place);
        return new PlanWing(
            [.. Loops(rest, wing.Surface.triangles).Select(loop => loop.ConvertAll(vertex => From(rest[vertex])))],
            [.. wing.Skeleton.Chains.Select(chain => chain.joints.Select(joint => From(joint)).ToList())]);
    }

    // Edges of one triangle alone, one after the other as the triangles have them.
    private static IEnumerable<List<int>> Loops(float3[] rest, int[] triangles)
    {
        int[] places = VertexWeld.Exact(rest);
        var next = new Dictionary<int, int>();
        foreach (MarginEdge edge in MeshMargin.Of(rest, triangles))
            next[places[edge.A]] = places[edge.B];
        while (next.Count > 0)
        {
            var loop = new List<int>();
            int at = next.Keys.First();
            while (next.Remove(at, out int after))
            {
                loop.Add(at);
                at = after;
            }

            yield return loop;
        }
    }
}
