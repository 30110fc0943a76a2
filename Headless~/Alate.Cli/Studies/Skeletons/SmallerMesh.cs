using Alate.Crowds;
using UnityEngine;

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
        int vertices = mesh.Positions.Length;
        var reducer = new TriangleReducer(new BakedSurface
        {
            Positions = mesh.Positions,
            Normals = new Vector3[vertices],
            Uvs = mesh.Uvs ?? new Vector2[vertices],
            Colours = mesh.Colours ?? new Color32[vertices],
            Parts = [new BakedPart("wing", null, false, mesh.Triangles)],
        });
        reducer.ReduceTo(triangles);
        if (reducer.Count > triangles)
        {
            throw new UserException(
                $"No fewer than {reducer.Count} triangles are left of {mesh.TriangleCount} where margins and seams stay as they are: "
                + $"--triangles {reducer.Count} or more.");
        }

        int[] corners = reducer.Parts(1)[0], kept = [.. corners.Distinct().Order()];
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
