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
            public const string Progress = "Flies '{0}' until each beat is like the one before.";
            public const string Save = "Save...";
            public const string SaveMessage = "One asset with the texture, the meshes and the materials.";

            public const string Shown = "Shown, slowed down";

            public static readonly GUIContent Prefab = new GUIContent(
                "Prefab", "Saves a prefab too: a crowd of the insect with a spawner, ready to be dropped into a scene.");
            public static readonly GUIContent Insect = new GUIContent("Insect", "The insect whose wings are flown. It is not changed.");
            public static readonly GUIContent Clips = new GUIContent(
                "Clips", "Loops that go into the texture; a crowd can blend two of them.");
            public static readonly GUIContent Frames = new GUIContent(
                "Frames", "Frames of each loop, 4 to 240; 48 keep the error between frames below 0.5 % of the wing length.");
        }

        [SerializeField] private InsectWings m_Insect;
        [SerializeField] private List<string> m_Clips = new List<string> { BakeMotion.Names[0] };
        [SerializeField] private int m_Frames = BakeSettings.DefaultFrames;
        [SerializeField] private bool m_Prefab = true;

        /// <summary>Height of the picture, and seconds that a beat takes in it.</summary>
        private const float k_PreviewHeight = 180f, k_BeatSeconds = 1.5f;

        private int m_Shown;

        private readonly InsectBaking m_Baking = new InsectBaking();

        [MenuItem(Content.Menu, false, 313)]
        private static void Open()
        {
            BakeWindow window = GetWindow<BakeWindow>(Content.Title);
            if (Selection.activeGameObject != null && Selection.activeGameObject.TryGetComponent(out InsectWings selected))
                window.m_Insect = selected;
        }

        private void OnDisable() => m_Baking.Dispose();

        // The picture moves.
        private void Update()
        {
            if (m_Baking.Preview != null)
                Repaint();
        }

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
                Bake();
            ShowResult();
        }

        // The bar is a window of its own and ends the groups of this one: what follows in OnGUI would find none.
        private void Bake()
        {
            try
            {
                m_Baking.Bake(m_Insect, m_Clips, m_Frames, (clip, share) =>
                    !EditorUtility.DisplayCancelableProgressBar(Content.Title, string.Format(Content.Progress, clip), share));
            }
            finally
            {
                EditorUtility.ClearProgressBar();
            }

            GUIUtility.ExitGUI();
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
            ShowPreview();
            m_Prefab = EditorGUILayout.Toggle(Content.Prefab, m_Prefab);
            if (!GUILayout.Button(Content.Save))
                return;
            SaveAs();
            GUIUtility.ExitGUI();
        }

        private void SaveAs()
        {
            string path = AssetPath.Ask(Content.Title, AssetPath.FileName(m_Insect.name + " Baked"), Content.SaveMessage);
            if (!string.IsNullOrEmpty(path) && m_Baking.Save(path) is BakedInsect saved)
                ProjectWindowUtil.ShowCreatedAsset(m_Prefab ? m_Baking.SavePrefab(saved, m_Insect) : (Object)saved);
        }

        private void ShowPreview()
        {
            m_Shown = Mathf.Clamp(EditorGUILayout.Popup(Content.Shown, m_Shown, m_Baking.Clips), 0, m_Baking.Clips.Length - 1);
            Rect area = EditorGUILayout.GetControlRect(false, k_PreviewHeight);
            if (Event.current.type == EventType.Repaint)
                m_Baking.Preview.Draw(area, m_Shown, (float)(EditorApplication.timeSinceStartup / k_BeatSeconds % 1.0));
        }
    }
}
