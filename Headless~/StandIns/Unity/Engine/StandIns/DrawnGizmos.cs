using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>What gizmos draw, while a test listens.</summary>
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

    internal static void AddSolid(string shape, Vector3 centre, Vector3 size) => Add(shape, centre,
        centre + new Vector3(0.5f * size.x, 0f, 0f), centre + new Vector3(0f, 0.5f * size.y, 0f), centre + new Vector3(0f, 0f, 0.5f * size.z));
}
