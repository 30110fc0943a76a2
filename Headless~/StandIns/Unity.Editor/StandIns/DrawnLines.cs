using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>Lines and discs that handles draw, while a test listens.</summary>
[Unity.StandIns.StandInExtension]
public static class DrawnLines
{
    /// <summary>Colour and points of each line or disc; a disc has its middle, and its normal times its radius. Null notes none.</summary>
    public static List<(Color Colour, Vector3[] Points)> Calls { get; set; }
}
