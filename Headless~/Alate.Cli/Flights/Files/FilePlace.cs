using System.Text.Json.Nodes;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A place of the insect in a file: millimetres to the right, up and ahead of the middle of the thorax.</summary>
internal static class FilePlace
{
    private const decimal k_Most = 1000m, k_PerMetre = 1000m;

    public static ListShape Shape { get; } = new(
        new NumberShape(-k_Most, k_Most, "millimetres"), 3, 3, "three numbers of millimetres: right, up, ahead");

    /// <summary>Half axes and the like.</summary>
    public static ListShape Lengths { get; } = new(
        new NumberShape(0.001m, k_Most, "millimetres"), 3, 3, "three lengths in millimetres: across, up, along");

    /// <summary>A checked place, metres.</summary>
    public static Vector3 Read(JsonPlace value) => new(
        FileNumber.ToPreset(value.Items[0].Text, k_PerMetre), FileNumber.ToPreset(value.Items[1].Text, k_PerMetre),
        FileNumber.ToPreset(value.Items[2].Text, k_PerMetre));

    /// <summary>A place in metres as the file has it.</summary>
    public static JsonArray Node(Vector3 metres) => new(
        FileNumber.Node(metres.x, k_PerMetre), FileNumber.Node(metres.y, k_PerMetre), FileNumber.Node(metres.z, k_PerMetre));
}
