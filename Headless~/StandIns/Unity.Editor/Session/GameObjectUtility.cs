using UnityEngine;

namespace UnityEditor;

public sealed class GameObjectUtility
{
    /// <summary>A child of the parent at its origin and on its layer; nothing without a parent.</summary>

    public static void SetParentAndAlign(GameObject child, GameObject parent)
    {
        if (parent == null)
            return;
        child.transform.SetParent(parent.transform, false);
        child.transform.localPosition = Vector3.zero;
        child.transform.localRotation = Quaternion.identity;
        child.transform.localScale = Vector3.one;
        child.layer = parent.layer;
    }

    public static void EnsureUniqueNameForSibling(GameObject self)
    {
        string first = self.name;
        self.name = GetUniqueNameForSibling(self.transform.parent, first);
    }

    public static string GetUniqueNameForSibling(Transform parent, string name)
    {
        if (parent == null || parent.Find(name) == null)
            return name;
        int number = 1;
        while (parent.Find($"{name} ({number})") != null)
            number++;
        return $"{name} ({number})";
    }

    public static StaticEditorFlags GetStaticEditorFlags(GameObject go) => ObjectState.FlagsOf(go).Value;
    public static void SetStaticEditorFlags(GameObject go, StaticEditorFlags flags) => ObjectState.FlagsOf(go).Value = flags;
}
