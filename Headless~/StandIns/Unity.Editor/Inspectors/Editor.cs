using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class Editor : ScriptableObject
{
    private SerializedObject _serialized;

    public Object target { get; set; }
    public Object[] targets { get; private set; }
    public SerializedObject serializedObject => _serialized ??= new SerializedObject(targets);
    public bool hasUnsavedChanges { get; protected set; }

    public virtual void OnInspectorGUI() => DrawDefaultInspector();

    public bool DrawDefaultInspector()
    {
        serializedObject.UpdateIfRequiredOrScript();
        foreach (SerializedProperty property in serializedObject.Visible())
            EditorGUILayout.PropertyField(property);
        return serializedObject.ApplyModifiedProperties();
    }

    public void DrawHeader() => throw Absent.Editor;
    public void Repaint()
    {
    }

    public virtual bool RequiresConstantRepaint() => false;
    public static Editor CreateEditor(Object targetObject) => CreateEditor([targetObject]);
    public static Editor CreateEditor(Object[] targetObjects)
    {
        Editor editor = Factory.Make<Editor>(Custom.EditorOf(targetObjects));
        editor.target = targetObjects[0];
        editor.targets = targetObjects;
        editor.Begin();
        return editor;
    }

    public static Editor CreateEditor(Object targetObject, Type editorType) => throw Absent.Editor;
    public static void CreateCachedEditor(Object targetObject, Type editorType, ref Editor previousEditor)
    {
        if (previousEditor != null && previousEditor.target == targetObject)
            return;
        if (previousEditor != null)
            DestroyImmediate(previousEditor);
        previousEditor = targetObject == null ? null : CreateEditor([targetObject]);
    }

    public virtual bool HasPreviewGUI() => false;

    public virtual void OnPreviewGUI(Rect r, GUIStyle background)
    {
    }

    public virtual void OnInteractivePreviewGUI(Rect r, GUIStyle background)
    {
    }

    public virtual void OnPreviewSettings()
    {
    }

    public virtual GUIContent GetPreviewTitle() => null;
    public virtual string GetInfoString() => null;
    protected static void DrawPropertiesExcluding(SerializedObject obj, params string[] propertyToExclude) => throw Absent.Editor;
    public virtual bool UseDefaultMargins() => true;
    public virtual Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height) => null;
}
