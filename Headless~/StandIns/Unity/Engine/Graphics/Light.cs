namespace UnityEngine;

public sealed class Light : Behaviour, IStateful
{
    public LightType type { get; set; } = LightType.Point;
    public Color color { get; set; } = Color.white;
    public float intensity { get; set; } = 1f;
    public float range { get; set; } = 10f;
    public float spotAngle { get; set; } = 30f;
    public LightShadows shadows { get; set; }

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (Light)copy;
        to.type = type;
        to.color = color;
        to.intensity = intensity;
        to.range = range;
        to.spotAngle = spotAngle;
        to.shadows = shadows;
    }
}

public enum LightType
{
    Spot = 0,
    Directional = 1,
    Point = 2,
    Rectangle = 3,
    Disc = 4,
}

public enum LightShadows
{
    None = 0,
    Hard = 1,
    Soft = 2,
}
