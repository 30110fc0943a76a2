using UnityEngine;

namespace UnityEditor;

public class ProjectWindowUtil
{
    public static void CreateAsset(Object asset, string pathName) => throw Absent.Editor;
    public static void ShowCreatedAsset(Object o) => Selection.activeObject = o;
}
