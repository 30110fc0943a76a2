using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Field)]
public sealed class SerializeField : Attribute;

[AttributeUsage(AttributeTargets.Field)]
public sealed class HideInInspector : Attribute;

[AttributeUsage(AttributeTargets.Field)]
public abstract class PropertyAttribute : Attribute
{
    public int order { get; set; }
}

[AttributeUsage(AttributeTargets.Field)]
public sealed class RangeAttribute(float min, float max) : PropertyAttribute
{
    public readonly float min = min;
    public readonly float max = max;
}

[AttributeUsage(AttributeTargets.Field)]
public sealed class MinAttribute(float min) : PropertyAttribute
{
    public readonly float min = min;
}

[AttributeUsage(AttributeTargets.Field)]
public class TooltipAttribute(string tooltip) : PropertyAttribute
{
    public readonly string tooltip = tooltip;
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class CreateAssetMenuAttribute : Attribute
{
    public string menuName { get; set; }
    public string fileName { get; set; }
    public int order { get; set; }
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class PreferBinarySerialization : Attribute;
