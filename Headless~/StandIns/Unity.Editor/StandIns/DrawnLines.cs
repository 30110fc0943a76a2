using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>Lines and discs that handles draw, while a test listens.</summary>
[Unity.StandIns.StandInExtension]
public static class DrawnLines
{
    /// <summary>Colour and points of each line or disc; a disc has its middle, and its normal times its radius. Null notes none.</summary>
    public static List<(Color Colour, Vector3[] Points)> Calls { get; set; }

    /// <summary>Widths of lines and rims that have one, pixels. Null notes none.</summary>
    public static List<float> Widths { get; set; }

    /// <summary>Texts and places of labels. Null notes none.</summary>
    public static List<(string Text, Vector3 Place)> Labels { get; set; }

    /// <summary>Rectangles with the colours of their faces and rims. Null notes none.</summary>
    public static List<(Rect Place, Color Face, Color Rim)> Rectangles { get; set; }
}
