using System;
using System.Collections;
using StandIns;
using UnityEngine;

namespace UnityEditor;

public class SceneView : SearchableEditorWindow
{
    public static event Action<SceneView> duringSceneGui
    {
        add => SceneViews.Drawing += value;
        remove => SceneViews.Drawing -= value;
    }

    public static event Action<SceneView> beforeSceneGui
    {
        add { }
        remove { }
    }

    public static SceneView lastActiveSceneView => SceneViews.LastActive;
    public static SceneView currentDrawingSceneView { get; }
    public Camera camera { get; }
    public Vector3 pivot { get; set; }
    public Quaternion rotation { get; set; }
    public float size { get; set; }
    public bool orthographic { get; set; }
    public bool drawGizmos { get; set; }
    public static ArrayList sceneViews { get; }

    /// <summary>Is counted: there is no window to draw again.</summary>
    public static void RepaintAll() => SceneViews.Repaints++;

    public bool Frame(Bounds bounds, bool instant = true)
    {
        pivot = bounds.center;
        size = bounds.extents.magnitude;
        return true;
    }

    public bool FrameSelected() => throw Absent.Editor;
    public void LookAt(Vector3 point) => throw Absent.Editor;
}
