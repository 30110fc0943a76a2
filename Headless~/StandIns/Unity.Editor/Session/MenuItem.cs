using System;

namespace UnityEditor;

[System.AttributeUsage(System.AttributeTargets.Method, AllowMultiple = true)]
public sealed class MenuItem : Attribute
{
    public string menuItem;
    public bool validate;
    public int priority;

    public MenuItem(string itemName)
    {
    }

    public MenuItem(string itemName, bool isValidateFunction)
    {
    }

    public MenuItem(string itemName, bool isValidateFunction, int priority)
    {
    }
}
