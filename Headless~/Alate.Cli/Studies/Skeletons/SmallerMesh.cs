using Alate.Geometry;

namespace Alate.Cli;

/// <summary>Mesh of a wing with fewer triangles, of some of its vertices.</summary>
internal static class SmallerMesh
{
    /// <summary>Makes it, as an OBJ file without its material.</summary>
    /// <param name="mesh">The whole one; the origin of the file is that of its positions.</param>
    /// <param name="triangles">Most triangles.</param>
    /// <exception cref="UserException">Margins and seams alone have more.</exception>
    public static byte[] Of(ObjMesh mesh, int triangles)
    {
        var reducer = new TriangleReducer(Array.ConvertAll(mesh.Positions, place => (float3)place), [mesh.Triangles]);
        reducer.ReduceTo(triangles);
        if (reducer.Count > triangles)
        {
            throw new UserException(
                $"No fewer than {reducer.Count} triangles are left of {mesh.TriangleCount} where margins and seams stay as they are: "
                + $"--triangles {reducer.Count} or more.");
        }

        int[] corners = reducer.Parts()[0], kept = [.. corners.Distinct().Order()];
        using var stream = new MemoryStream();
        ObjWriter.Write(
            new SurfaceMesh
            {
                positions = Picked(mesh.Positions, kept),
                uvs = Picked(mesh.Uvs, kept),
                colours = Picked(mesh.Colours, kept),
                triangles = Array.ConvertAll(corners, vertex => Array.BinarySearch(kept, vertex)),
            },
            stream);
        return stream.ToArray();
    }

    private static T[] Picked<T>(T[] values, int[] kept) => values == null ? null : Array.ConvertAll(kept, vertex => values[vertex]);
}
