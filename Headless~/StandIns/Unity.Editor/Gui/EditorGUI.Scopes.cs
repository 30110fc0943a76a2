using System;
using UnityEngine;

namespace UnityEditor;

public partial class EditorGUI
{
    public struct DisabledScope : IDisposable
    {
        public DisabledScope(bool disabled) => GuiPage.Needed.Begin(disabled ? "disabled" : "enabled");

        public void Dispose() => GuiPage.Needed.End("abled");
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
        public IndentLevelScope() : this(1)
        {
        }

        public IndentLevelScope(int increment) => GuiPage.Needed.Begin("indent");

        protected override void CloseScope() => GuiPage.Needed.End("indent");
    }

    public class PropertyScope : GUI.Scope
    {
        public PropertyScope(Rect totalPosition, GUIContent label, SerializedProperty property)
        {
            content = label ?? new GUIContent(property.displayName, property.tooltip);
            GuiPage.Needed.Begin("property");
        }

        public GUIContent content { get; protected set; }

        protected override void CloseScope() => GuiPage.Needed.End("property");
    }
}
