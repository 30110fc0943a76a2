namespace UnityEngine.Rendering;

public enum BlendMode
{
    Zero = 0,
    One = 1,
    SrcAlpha = 5,
    OneMinusSrcAlpha = 10,
}
