using System;

namespace UnityEngine;

public sealed class Texture2D : Texture
{
    private readonly Color[] _pixels;

    public Texture2D(int width, int height)
    {
        if (width <= 0 || height <= 0)
            throw new UnityException("Failed to create texture because of invalid parameters.");
        this.width = width;
        this.height = height;
        _pixels = new Color[width * height];
        Array.Fill(_pixels, new Color(0.8f, 0.8f, 0.8f, 0.8f));
    }

    public Color GetPixel(int x, int y)
    {
        CheckAlive();
        return _pixels[Place(x, y)];
    }

    public void SetPixel(int x, int y, Color color)
    {
        CheckAlive();
        _pixels[Place(x, y)] = color;
    }

    public void SetPixels(Color[] colors)
    {
        CheckAlive();
        if (colors.Length < _pixels.Length)
            throw new ArgumentException($"The texture has {_pixels.Length} pixels, the array {colors.Length}.");
        Array.Copy(colors, _pixels, _pixels.Length);
    }

    public void Apply() => CheckAlive();

    private int Place(int x, int y) => Math.Clamp(y, 0, height - 1) * width + Math.Clamp(x, 0, width - 1);
}
