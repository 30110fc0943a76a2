using System;
using UnityEngine;

namespace UnityEditor;

public partial class EditorGUI
{
    public struct DisabledScope : IDisposable
    {
        public DisabledScope(bool disabled)
        {
        }

        public void Dispose()
        {
        }
    }

    public class ChangeCheckScope : GUI.Scope
    {
        public bool changed => throw Absent.Editor;

        protected override void CloseScope()
        {
        }
    }

    public class IndentLevelScope : GUI.Scope
    {
        public IndentLevelScope()
        {
        }

        public IndentLevelScope(int increment)
        {
        }

        protected override void CloseScope()
        {
        }
    }

    public class PropertyScope : GUI.Scope
    {
        public PropertyScope(Rect totalPosition, GUIContent label, SerializedProperty property)
        {
            content = label;
        }

        public GUIContent content { get; protected set; }

        protected override void CloseScope()
        {
        }
    }
}
