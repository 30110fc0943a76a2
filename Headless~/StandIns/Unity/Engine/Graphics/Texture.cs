namespace UnityEngine;

public enum TextureWrapMode
{
    Repeat = 0,
    Clamp = 1,
    Mirror = 2,
    MirrorOnce = 3,
}

public enum TextureFormat
{
    Alpha8 = 1,
    RGB24 = 3,
    RGBA32 = 4,
    ARGB32 = 5,
    RGBAHalf = 17,
    RGBAFloat = 20,
}

public enum FilterMode
{
    Point = 0,
    Bilinear = 1,
    Trilinear = 2,
}

/// <summary>A size without pixels.</summary>
public class Texture : Object
{
    protected Texture()
    {
    }

    public virtual int width { get; set; }
    public virtual int height { get; set; }
    public virtual bool isReadable => true;
    public TextureWrapMode wrapMode { get; set; }
    public FilterMode filterMode { get; set; } = FilterMode.Bilinear;
}
