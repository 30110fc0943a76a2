using System;

namespace UnityEditor;

[System.AttributeUsage(System.AttributeTargets.Class)]
public class InitializeOnLoadAttribute : Attribute
{
    public InitializeOnLoadAttribute()
    {
    }
}
