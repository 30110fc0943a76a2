using System;

namespace UnityEngine;

public sealed class Texture2D : Texture
{
    private Color[] _pixels;
    private bool _isReadable = true;

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
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear)
        : this(width, height, textureFormat, mipChain)
    {
    }

    public TextureFormat format { get; }

    public override bool isReadable => _isReadable;

    public Color GetPixel(int x, int y)
    {
        CheckReadable();
        return _pixels[Place(x, y)];
    }

    public Color[] GetPixels()
    {
        CheckReadable();
        return (Color[])_pixels.Clone();
    }

    public Color32[] GetPixels32()
    {
        CheckReadable();
        return Array.ConvertAll(_pixels, pixel => (Color32)pixel);
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

    public void SetPixels32(Color32[] colors)
    {
        CheckReadable();
        if (colors.Length < _pixels.Length)
            throw new ArgumentException($"The texture has {_pixels.Length} pixels, the array {colors.Length}.");
        for (int k = 0; k < _pixels.Length; k++)
            _pixels[k] = colors[k];
    }

    /// <summary>Takes the place of what a picture shows, which here is nothing: black.</summary>
    public void ReadPixels(Rect source, int destX, int destY)
    {
        CheckReadable();
        (int across, int up) = RenderTexture.active is { } from ? (from.width, from.height) : (Screen.width, Screen.height);
        if (source.xMin < 0f || source.yMin < 0f || source.xMax > across || source.yMax > up
            || destX + source.width > width || destY + source.height > height)
        {
            Debug.LogError("Reading pixels out of bounds.");
            return;
        }

        Array.Fill(_pixels, Color.black);
    }

    public void Apply() => CheckReadable();

    public void Apply(bool updateMipmaps) => CheckReadable();

    public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
    {
        CheckReadable();
        _isReadable = !makeNoLongerReadable;
    }

    internal void Become(int newWidth, int newHeight, Color32[] pixels, bool readable)
    {
        CheckAlive();
        width = newWidth;
        height = newHeight;
        _pixels = Array.ConvertAll(pixels, pixel => (Color)pixel);
        _isReadable = readable;
    }

    private void CheckReadable()
    {
        CheckAlive();
        if (!_isReadable)
            throw new UnityException($"Texture '{name}' is not readable, the texture memory can not be accessed from scripts.");
    }

    private int Place(int x, int y) => Math.Clamp(y, 0, height - 1) * width + Math.Clamp(x, 0, width - 1);
}
