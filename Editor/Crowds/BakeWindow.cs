using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Bakes an insect of the scene or a prefab for crowds: shows size and errors, then saves the asset.</summary>
    internal sealed class BakeWindow : EditorWindow
    {
        private static class Content
        {
            public const string Menu = "Assets/Create/Alate/Baked Insect...";
            public const string Title = "Bake Insect";
            public const string Pick = "Pick an insect: an object of the scene or a prefab with the component Insect Wings.";
            public const string Bake = "Bake";
            public const string Save = "Save...";
            public const string SaveMessage = "One asset with the texture, the meshes and the materials.";

            public static readonly GUIContent Insect = new GUIContent("Insect", "The insect whose wings are flown. It is not changed.");
            public static readonly GUIContent Clips = new GUIContent("Clips", "Loops that go into the texture; a crowd can blend two of them.");
            public static readonly GUIContent Frames = new GUIContent("Frames", "Frames of each loop, 4 to 240; 48 keep the error between frames below 0.5 % of the wing length.");
        }

        [SerializeField] private InsectWings m_Insect;
        [SerializeField] private List<string> m_Clips = new List<string> { BakeMotion.Names[0] };
        [SerializeField] private int m_Frames = BakeSettings.DefaultFrames;

        private readonly InsectBaking m_Baking = new InsectBaking();

        [MenuItem(Content.Menu, false, 313)]
        private static void Open()
        {
            BakeWindow window = GetWindow<BakeWindow>(Content.Title);
            if (Selection.activeGameObject != null && Selection.activeGameObject.TryGetComponent(out InsectWings selected))
                window.m_Insect = selected;
        }

        private void OnDisable() => m_Baking.Dispose();

        private void OnGUI()
        {
            EditorGUI.BeginChangeCheck();
            m_Insect = (InsectWings)EditorGUILayout.ObjectField(Content.Insect, m_Insect, typeof(InsectWings), true);
            ShowClips();
            m_Frames = EditorGUILayout.IntSlider(Content.Frames, m_Frames, BakeSettings.MinFrames, BakeSettings.MaxFrames);
            if (EditorGUI.EndChangeCheck())
                m_Baking.Dispose();
            if (m_Insect == null)
            {
                EditorGUILayout.HelpBox(Content.Pick, MessageType.Info);
                return;
            }

            if (GUILayout.Button(Content.Bake))
                m_Baking.Bake(m_Insect, m_Clips, m_Frames);
            ShowResult();
        }

        private void ShowClips()
        {
            EditorGUILayout.LabelField(Content.Clips);
            foreach (string name in BakeMotion.Names)
            {
                bool had = m_Clips.Contains(name), has = EditorGUILayout.Toggle(name, had);
                if (has && !had)
                    m_Clips.Add(name);
                if (!has && had)
                    m_Clips.Remove(name);
            }
        }

        private void ShowResult()
        {
            if (m_Baking.Problem != null)
                EditorGUILayout.HelpBox(m_Baking.Problem, MessageType.Error);
            if (m_Baking.Made == null)
                return;
            EditorGUILayout.HelpBox(string.Join("\n", m_Baking.Describe().ToArray()), MessageType.None);
            if (!GUILayout.Button(Content.Save))
                return;
            string path = AssetPath.Ask(Content.Title, AssetPath.FileName(m_Insect.name + " Baked"), Content.SaveMessage);
            if (!string.IsNullOrEmpty(path) && m_Baking.Save(path) is BakedInsect saved)
                ProjectWindowUtil.ShowCreatedAsset(saved);
        }
    }
}
