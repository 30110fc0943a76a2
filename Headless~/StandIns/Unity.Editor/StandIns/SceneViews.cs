using System;
using UnityEditor;

namespace StandIns;

/// <summary>Scene views of the editor: the last that was active, who draws in them, and how often they were asked to draw again.</summary>
[Unity.StandIns.StandInExtension]
public static class SceneViews
{
    /// <summary>The view that was active last; null for none.</summary>
    public static SceneView LastActive { get; set; }

    /// <summary>Number of times that all views were asked to draw again.</summary>
    public static int Repaints { get; internal set; }

    internal static Action<SceneView> Drawing { get; set; }

    /// <summary>Lets all who draw in scene views handle the current event.</summary>
    public static void Draw(SceneView view) => Drawing?.Invoke(view);
}
