using System;

namespace UnityEngine;

public sealed class Texture2D : Texture
{
    private readonly Color[] _pixels;

    public Texture2D(int width, int height)
        : this(width, height, TextureFormat.RGBA32, true)
    {
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
    {
        if (width <= 0 || height <= 0)
            throw new UnityException("Failed to create texture because of invalid parameters.");
        this.width = width;
        this.height = height;
        _pixels = new Color[width * height];
        Array.Fill(_pixels, new Color(0.8f, 0.8f, 0.8f, 0.8f));
        format = textureFormat;
        isReadable = true;
    }

    public TextureFormat format { get; }

    public bool isReadable { get; private set; }

    public Color GetPixel(int x, int y)
    {
        CheckReadable();
        return _pixels[Place(x, y)];
    }

    public void SetPixel(int x, int y, Color color)
    {
        CheckReadable();
        _pixels[Place(x, y)] = color;
    }

    public void SetPixels(Color[] colors)
    {
        CheckReadable();
        if (colors.Length < _pixels.Length)
            throw new ArgumentException($"The texture has {_pixels.Length} pixels, the array {colors.Length}.");
        Array.Copy(colors, _pixels, _pixels.Length);
    }

    public void SetPixels32(Color32[] colors) => SetPixels(Array.ConvertAll(colors, color => (Color)color));

    public Color32[] GetPixels32()
    {
        CheckReadable();
        return Array.ConvertAll(_pixels, color => (Color32)color);
    }

    public void Apply() => Apply(true, false);

    public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
    {
        CheckReadable();
        isReadable = !makeNoLongerReadable;
    }

    private void CheckReadable()
    {
        CheckAlive();
        if (!isReadable)
            throw new UnityException($"Texture '{name}' is not readable.");
    }

    private int Place(int x, int y) => Math.Clamp(y, 0, height - 1) * width + Math.Clamp(x, 0, width - 1);
}
