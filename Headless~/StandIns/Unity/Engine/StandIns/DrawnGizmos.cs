using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>Shapes that gizmos draw, while a test listens.</summary>
[Unity.StandIns.StandInExtension]
public static class DrawnGizmos
{
    /// <summary>
    /// Shape, colour and places in the world: both ends of a line; middle and right, upper and far side of a box, a ball or a mesh. Null
    /// notes none.
    /// </summary>
    public static List<(string Shape, Color Colour, Vector3[] Places)> Calls { get; set; }

    internal static void Add(string shape, params Vector3[] places) =>
        Calls?.Add((shape, Gizmos.color, System.Array.ConvertAll(places, Gizmos.matrix.MultiplyPoint3x4)));

    internal static void AddSolid(string shape, Vector3 centre, Vector3 size) => Add(
        shape, centre, centre + 0.5f * size.x * Vector3.right, centre + 0.5f * size.y * Vector3.up,
        centre + 0.5f * size.z * Vector3.forward);
}
