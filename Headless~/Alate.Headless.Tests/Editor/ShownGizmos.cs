using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Draws the gizmos of a selected component, as the editor does: by the methods that are marked for its type.</summary>
internal static class ShownGizmos
{
    /// <summary>Shape, colour and places of what is drawn.</summary>
    public static List<(string Shape, Color Colour, Vector3[] Places)> Of(Component component)
    {
        MethodInfo draw = typeof(Alate.Editor.BeatGraph).Assembly.GetTypes()
            .SelectMany(type => type.GetMethods(BindingFlags.Static | BindingFlags.NonPublic))
            .Single(method => method.IsDefined(typeof(DrawGizmo)) && method.GetParameters()[0].ParameterType == component.GetType());
        Matrix4x4 before = Gizmos.matrix;
        DrawnGizmos.Calls = [];
        try
        {
            draw.Invoke(null, [component, GizmoType.Selected]);
            if (Gizmos.matrix != before)
                throw new InvalidOperationException("The matrix of the gizmos is left changed.");
            return DrawnGizmos.Calls;
        }
        finally
        {
            DrawnGizmos.Calls = null;
        }
    }
}
