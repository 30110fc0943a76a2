using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Color[] colors
    {
        get => ReadColors();
        set => WriteChannel<Color>(VertexAttribute.Color, value, VertexAttributeFormat.Float32, 4);
    }

    public Color32[] colors32
    {
        get => Array.ConvertAll(ReadColors(), color => (Color32)color);
        set => WriteChannel<Color>(
            VertexAttribute.Color, Array.ConvertAll(value ?? [], color => (Color)color), VertexAttributeFormat.UNorm8, 4);
    }

    public void GetColors(List<Color> colors) => Fill(colors, this.colors);
    public void GetColors(List<Color32> colors) => Fill(colors, colors32);
    public void SetColors(List<Color> inColors) => colors = [.. inColors];
    public void SetColors(List<Color32> inColors) => colors32 = [.. inColors];
    public void SetColors(Color[] inColors) => colors = inColors;
    public void SetColors(Color32[] inColors) => colors32 = inColors;

    private Color[] ReadColors() => ReadChannel<Color>(VertexAttribute.Color);
}
