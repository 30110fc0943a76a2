using System;

namespace UnityEngine;

public sealed class AddComponentMenu : Attribute
{
    public AddComponentMenu(string menuName) : this(menuName, 0)
    {
    }

    public AddComponentMenu(string menuName, int order)
    {
        componentMenu = menuName;
        componentOrder = order;
    }

    public string componentMenu { get; }
    public int componentOrder { get; }
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent : Attribute
{
    public Type m_Type0;
    public Type m_Type1;
    public Type m_Type2;

    public RequireComponent(Type requiredComponent) => m_Type0 = requiredComponent;

    public RequireComponent(Type requiredComponent, Type requiredComponent2) : this(requiredComponent) => m_Type1 = requiredComponent2;

    public RequireComponent(Type requiredComponent, Type requiredComponent2, Type requiredComponent3)
        : this(requiredComponent, requiredComponent2) => m_Type2 = requiredComponent3;
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class DisallowMultipleComponent : Attribute;

public sealed class ExecuteAlways : Attribute;

public sealed class ExecuteInEditMode : Attribute;

[AttributeUsage(AttributeTargets.Class)]
public class DefaultExecutionOrder(int order) : Attribute
{
    public int order { get; } = order;
}

[AttributeUsage(AttributeTargets.Class)]
public class SelectionBaseAttribute : Attribute;

[AttributeUsage(AttributeTargets.Class)]
public class IconAttribute(string path) : Attribute
{
    public string path { get; } = path;
}

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ContextMenu(string itemName, bool isValidateFunction, int priority) : Attribute
{
    public readonly string menuItem = itemName;
    public readonly bool validate = isValidateFunction;
    public readonly int priority = priority;

    public ContextMenu(string itemName) : this(itemName, false)
    {
    }

    public ContextMenu(string itemName, bool isValidateFunction) : this(itemName, isValidateFunction, isValidateFunction ? 0 : 1000000)
    {
    }
}
