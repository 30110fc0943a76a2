using System;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class CanEditMultipleObjects : Attribute
{
    public CanEditMultipleObjects()
    {
    }
}
