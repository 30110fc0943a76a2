using System;

namespace UnityEditor;

[System.AttributeUsage(System.AttributeTargets.Method)]
public class InitializeOnLoadMethodAttribute : Attribute
{
    public InitializeOnLoadMethodAttribute()
    {
    }
}
