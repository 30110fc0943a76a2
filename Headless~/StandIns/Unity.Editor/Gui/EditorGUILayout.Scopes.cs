using UnityEngine;

namespace UnityEditor;

public partial class EditorGUILayout
{
    public class HorizontalScope : GUI.Scope
    {
        public HorizontalScope(params GUILayoutOption[] options) => GuiPage.Needed.Begin("horizontal");

        public HorizontalScope(GUIStyle style, params GUILayoutOption[] options)
        {
        }

        public Rect rect { get; protected set; }

        protected override void CloseScope() => GuiPage.Needed.End("horizontal");
    }

    public class VerticalScope : GUI.Scope
    {
        public VerticalScope(params GUILayoutOption[] options)
        {
        }

        public VerticalScope(GUIStyle style, params GUILayoutOption[] options)
        {
        }

        public Rect rect { get; protected set; }

        protected override void CloseScope()
        {
        }
    }
}
