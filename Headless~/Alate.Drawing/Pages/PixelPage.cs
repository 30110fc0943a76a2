using Alate.Formats;
using UnityEngine;

namespace Alate.Drawing;

/// <summary>A picture of insects with labels, on paper of its own so that it reads on any ground.</summary>
internal sealed class PixelPage
{
    /// <summary>Pixels of a unit of length.</summary>
    public const float Fineness = 1.5f;

    private static readonly float3 s_Ink = Shading.Colour(0x3d3a34), s_Pale = Shading.Colour(0x746d60);

    private readonly List<(PhotoScene Scene, Pose Pose, StripPanel Panel)> m_Photos = [];
    private readonly List<(float2[] Points, float Pen, float3 Colour)> m_Strokes = [];
    private readonly List<PixelWords> m_Words = [];

    /// <summary>Words, in the order of writing.</summary>
    public IReadOnlyList<PixelWords> Words => m_Words;

    /// <summary>Texts that are written, in order.</summary>
    public IReadOnlyList<string> Texts => m_Words.ConvertAll(words => words.Text);

    /// <summary>Places of the photos, in order.</summary>
    public IReadOnlyList<StripPanel> Panels => m_Photos.ConvertAll(photo => photo.Panel);

    /// <summary>Adds a ring.</summary>
    public void Ring(float2 middle, float radius, int rgb, float thickness = 1f)
    {
        const int k_Corners = 24;
        Stroke([.. Enumerable.Range(0, k_Corners + 1).Select(k =>
        {
            math.sincos(k * 2f * math.PI / k_Corners, out float sine, out float cosine);
            return middle + radius * new float2(cosine, sine);
        })], rgb, thickness);
    }

    /// <summary>Lines and the strokes of words, in order: their points, colours and half widths.</summary>
    public IReadOnlyList<(float2[] Points, float Pen, float3 Colour)> Strokes => m_Strokes;

    /// <summary>Width and height, units.</summary>
    public float2 Size { get; private set; }

    /// <summary>Words for those who do not see the picture.</summary>
    public string Title { get; private set; }

    /// <summary>Adds a pose of an insect.</summary>
    public void Add(PhotoScene scene, Pose pose, StripPanel panel) => m_Photos.Add((scene, pose, panel));

    /// <summary>Adds a line of text.</summary>
    /// <param name="x">Where its anchor lies.</param>
    /// <param name="y">Its base line.</param>
    /// <param name="size">Size of the letters.</param>
    /// <param name="text">Any characters.</param>
    /// <param name="anchor">start, middle or end.</param>
    /// <param name="look">t for pale, b for bold, or nothing.</param>
    public void Text(float x, float y, float size, string text, string anchor = "start", string look = "")
    {
        (List<float2[]> strokes, float pen) = Lettering.Strokes(text, size, look == "b");
        float left = x - (anchor == "end" ? 1f : anchor == "middle" ? 0.5f : 0f) * Lettering.Width(text, size);
        foreach (float2[] stroke in strokes)
            m_Strokes.Add((Array.ConvertAll(stroke, point => point + new float2(left, y)), pen, look == "t" ? s_Pale : s_Ink));
        m_Words.Add(new PixelWords(text, new float2(left, y), size, anchor, look));
    }

    /// <summary>Adds a straight line.</summary>
    public void Line(float x1, float y1, float x2, float y2, int rgb, float thickness = 1f) =>
        Stroke([new float2(x1, y1), new float2(x2, y2)], rgb, thickness);

    /// <summary>Adds a line through points.</summary>
    public void Stroke(float2[] points, int rgb, float thickness = 1f) =>
        m_Strokes.Add((points, 0.5f * thickness, Shading.Colour(rgb)));

    /// <summary>The whole file.</summary>
    /// <param name="width">Units of the picture.</param>
    /// <param name="height">Units of the picture.</param>
    /// <param name="title">What it shows, for those who do not see it.</param>
    public byte[] Finish(float width, float height, string title) => End(width, height, title).Write();

    /// <summary>Gives the picture its size and title.</summary>
    public PixelPage End(float width, float height, string title)
    {
        Size = new float2(width, height);
        Title = title;
        return this;
    }

    /// <summary>The whole file of a picture that has its size.</summary>
    /// <param name="isSmall">True for 255 colours, in half the bytes, where a page holds many small insects.</param>
    public byte[] Write(bool isSmall = false)
    {
        var size = (int2)math.round(Fineness * Size);
        string[] texts = [Title, .. Texts];
        return isSmall ? IndexedPng.Write(size.x, size.y, [Draw(size)], 1, true, texts)
            : TrueColourPng.Write(size.x, size.y, Draw(size), texts);
    }

    /// <summary>The pixels, rows from above.</summary>
    public Color32[] Draw(int2 size)
    {
        var pixels = new float3[size.x * size.y];
        Array.Fill(pixels, Shading.Paper);
        long largest = m_Photos.Select(photo => SampleGrid.BytesOf(PhotoScene.SizeOf(photo.Panel, Fineness))).DefaultIfEmpty().Max();
        Color32[][] painted = Concurrently.Map(m_Photos, largest, photo => photo.Scene.Draw(photo.Pose, photo.Panel, Fineness));
        for (int k = 0; k < painted.Length; k++)
        {
            StripPanel panel = m_Photos[k].Panel;
            Blend(pixels, size, painted[k], (int2)math.round(Fineness * new float2(panel.Left, panel.Top)),
                PhotoScene.SizeOf(panel, Fineness));
        }

        foreach ((float2[] points, float pen, float3 colour) in m_Strokes)
        {
            foreach ((int pixel, float covered) in Pen.Cover(size, Array.ConvertAll(points, point => Fineness * point), pen * Fineness))
                pixels[pixel] = math.lerp(pixels[pixel], colour, covered);
        }

        return Array.ConvertAll(pixels, Shading.Bytes);
    }

    // What is paper in a photo leaves its neighbours as they are: insects may reach beyond their panels.
    private static void Blend(float3[] pixels, int2 size, Color32[] photo, int2 corner, int2 photoSize)
    {
        for (int k = 0; k < photo.Length; k++)
        {
            int2 place = corner + new int2(k % photoSize.x, k / photoSize.x);
            var colour = new float3(photo[k].r, photo[k].g, photo[k].b);
            if (math.all(place >= 0) && math.all(place < size) && math.any(math.abs(colour / 255f - Shading.Paper) > 0.004f))
                pixels[place.y * size.x + place.x] = colour / 255f;
        }
    }
}
