using System;
using System.Runtime.CompilerServices;
using Unity.Collections;

namespace UnityEngine;

public sealed class Texture2D : Texture
{
    private readonly NativeArray<Color> _floats;
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
        format = textureFormat;
        if (format == TextureFormat.RGBAFloat)
        {
            _floats = new NativeArray<Color>(width * height, Allocator.Persistent);
            return;
        }

        _pixels = new Color[width * height];
        Array.Fill(_pixels, new Color(0.8f, 0.8f, 0.8f, 0.8f));
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear)
        : this(width, height, textureFormat, mipChain)
    {
    }

    public TextureFormat format { get; }

    public override bool isReadable => _isReadable;

    private Span<Color> Pixels => _floats.IsCreated ? _floats.AsSpan() : _pixels;

    /// <summary>The memory itself, of a texture of floats: the only one whose pixels lie here as on the device.</summary>
    public NativeArray<T> GetPixelData<T>(int mipLevel) where T : struct
    {
        CheckReadable();
        if (mipLevel != 0)
            throw new ArgumentException($"The texture has no mip level {mipLevel}.");
        return _floats.IsCreated
            ? _floats.Reinterpret<T>(Unsafe.SizeOf<Color>())
            : throw new NotSupportedException($"No pixel data of {format}.");
    }

    public Color GetPixel(int x, int y)
    {
        CheckReadable();
        return Pixels[Place(x, y)];
    }

    public Color[] GetPixels()
    {
        CheckReadable();
        return Pixels.ToArray();
    }

    public Color32[] GetPixels32()
    {
        CheckReadable();
        return Array.ConvertAll(Pixels.ToArray(), pixel => (Color32)pixel);
    }

    /// <summary>Pixels as the graphics card has them, whether scripts may read them or not.</summary>
    [Unity.StandIns.StandInExtension]
    public Color[] CopyPixels()
    {
        CheckAlive();
        return Pixels.ToArray();
    }

    public void SetPixel(int x, int y, Color color)
    {
        CheckReadable();
        Pixels[Place(x, y)] = color;
    }

    public void SetPixels(Color[] colors)
    {
        CheckReadable();
        if (colors.Length < Pixels.Length)
            throw new ArgumentException($"The texture has {Pixels.Length} pixels, the array {colors.Length}.");
        colors.AsSpan(0, Pixels.Length).CopyTo(Pixels);
    }

    public void SetPixels32(Color32[] colors)
    {
        CheckReadable();
        if (colors.Length < Pixels.Length)
            throw new ArgumentException($"The texture has {Pixels.Length} pixels, the array {colors.Length}.");
        for (int k = 0; k < Pixels.Length; k++)
            Pixels[k] = colors[k];
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

        Pixels.Fill(Color.black);
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

    private protected override void Released()
    {
        if (_floats.IsCreated)
            _floats.Dispose();
    }

    private void CheckReadable()
    {
        CheckAlive();
        if (!_isReadable)
            throw new UnityException($"Texture '{name}' is not readable, the texture memory can not be accessed from scripts.");
    }

    private int Place(int x, int y) => Math.Clamp(y, 0, height - 1) * width + Math.Clamp(x, 0, width - 1);
}
