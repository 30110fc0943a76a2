using System;
using Object = UnityEngine.Object;

namespace UnityEditor;

public struct GlobalObjectId : IEquatable<GlobalObjectId>
{
    public static GlobalObjectId GetGlobalObjectIdSlow(Object targetObject) => throw Absent.Editor;
    public static Object GlobalObjectIdentifierToObjectSlow(GlobalObjectId id) => throw Absent.Editor;
    public static bool TryParse(string stringValue, out GlobalObjectId id) => throw Absent.Editor;
    public bool Equals(GlobalObjectId other) => throw Absent.Editor;
    public override string ToString() => throw Absent.Editor;
}
