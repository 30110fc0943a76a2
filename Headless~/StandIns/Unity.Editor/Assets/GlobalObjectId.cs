using System;
using System.Globalization;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Names an object as long as it lives; there are no files by which it could be found again later.</summary>
public struct GlobalObjectId : IEquatable<GlobalObjectId>
{
    private const string k_Prefix = "GlobalObjectId_V1-";
    private int _instance;

    public static GlobalObjectId GetGlobalObjectIdSlow(Object targetObject) =>
        new() { _instance = targetObject == null ? 0 : targetObject.GetInstanceID() };

    public static Object GlobalObjectIdentifierToObjectSlow(GlobalObjectId id) =>
        Array.Find(Resources.FindObjectsOfTypeAll<Object>(), o => o.GetInstanceID() == id._instance);

    public static bool TryParse(string stringValue, out GlobalObjectId id)
    {
        id = default;
        return stringValue != null && stringValue.StartsWith(k_Prefix, StringComparison.Ordinal)
            && int.TryParse(
                stringValue.AsSpan(k_Prefix.Length), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out id._instance);
    }

    public bool Equals(GlobalObjectId other) => _instance == other._instance;

    public override string ToString() => k_Prefix + _instance.ToString(CultureInfo.InvariantCulture);
}
