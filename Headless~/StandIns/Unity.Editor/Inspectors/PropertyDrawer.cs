using System.Reflection;
using UnityEngine;

namespace UnityEditor;

public abstract class PropertyDrawer : GUIDrawer
{
    public FieldInfo fieldInfo { get; }
    public PropertyAttribute attribute { get; }
    public string preferredLabel { get; }

    public virtual void OnGUI(Rect position, SerializedProperty property, GUIContent label)
    {
    }

    public virtual float GetPropertyHeight(SerializedProperty property, GUIContent label) => 0f;
}
