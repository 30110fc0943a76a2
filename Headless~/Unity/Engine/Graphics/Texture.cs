namespace UnityEngine;

/// <summary>A size without pixels.</summary>
public class Texture : Object
{
    protected Texture()
    {
    }

    public virtual int width { get; set; }
    public virtual int height { get; set; }
    public virtual bool isReadable => true;
}
