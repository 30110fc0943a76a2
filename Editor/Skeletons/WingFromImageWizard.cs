using System;
using Alate.Authoring;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Makes the mesh and skeleton of a wing from a picture of it.</summary>
    internal sealed class WingFromImageWizard : EditorWindow
    {
        private static class Content
        {
            public const string Menu = "Assets/Create/Alate/Wing from Image...";
            public const string Title = "Wing from Image";
            public const string Pick =
                "Pick a picture of one wing on plain or transparent ground: a silhouette, a line drawing or a photo.";
            public const string Trace = "Trace";
            public const string Save = "Save Mesh and Skeleton";

            public static readonly GUIContent Image = new GUIContent(
                "Image", "A PNG or JPEG picture of one wing. It is read from its file, in full size.");
            public static readonly GUIContent Chains = new GUIContent(
                "Chains", "Chains of joints from the leading to the trailing edge, 3 to 16.");
            public static readonly GUIContent Joints = new GUIContent("Joints", "Joints of each chain from root to tip, 3 to 16.");
            public static readonly GUIContent Triangles = new GUIContent(
                "Triangles", "Triangles of the mesh, 50 to 200000; it gets exactly so many.");
            public static readonly GUIContent Length = new GUIContent("Length", "From hinge to tip in the mesh, scene units, above 0.");
            public static readonly GUIContent Leading = new GUIContent(
                "Leading Edge", "The side of the picture on which the leading edge lies.");
            public static readonly GUIContent VeinWidths = new GUIContent("Vein Widths", "Measure the veins that chains follow, so that "
                + "thick ones are stiffer. For pictures that show widths, all veins in one shade.");
            public static readonly GUIContent HasHinge = new GUIContent(
                "Set Hinge", "Say where the wing turns. Without it the hinge lies where the veins meet, or is guessed.");
            public static readonly GUIContent Hinge = new GUIContent(
                "Hinge", "Pixels from the picture's top left corner, y down. A click in the picture sets it.");
        }

        [SerializeField] private Texture2D m_Image;
        [SerializeField] private int m_Chains = 5;
        [SerializeField] private int m_Joints = 5;
        [SerializeField] private int m_Triangles = 1000;
        [SerializeField] private float m_Length = 1f;
        [SerializeField] private WingImageSide m_Leading;
        [SerializeField] private bool m_VeinWidths;
        [SerializeField] private bool m_HasHinge;
        [SerializeField] private Vector2 m_Hinge;

        private Texture2D m_Picture;
        private WingImageTracing m_Tracing;
        private string m_Unreadable;
        private Vector2 m_Scroll;
        private bool m_IsSaved;

        [MenuItem(Content.Menu, false, 311)]
        private static void Open()
        {
            WingFromImageWizard window = GetWindow<WingFromImageWizard>(Content.Title);
            if (Selection.activeObject is Texture2D selected)
                window.Pick(selected);
        }

        private void OnDisable() => Forget();

        private void OnGUI()
        {
            m_Scroll = EditorGUILayout.BeginScrollView(m_Scroll);
            var image = (Texture2D)EditorGUILayout.ObjectField(Content.Image, m_Image, typeof(Texture2D), false);
            if (image != m_Image)
                Pick(image);
            if (m_Image == null)
                EditorGUILayout.HelpBox(Content.Pick, MessageType.Info);
            else
                ShowImage();
            EditorGUILayout.EndScrollView();
        }

        private void ShowImage()
        {
            if (m_Picture == null && m_Unreadable == null)
                Read();
            if (m_Unreadable != null)
            {
                EditorGUILayout.HelpBox(m_Unreadable, MessageType.Error);
                return;
            }

            EditorGUI.BeginChangeCheck();
            ShowSettings();
            if (EditorGUI.EndChangeCheck())
                Drop();
            if (GUILayout.Button(Content.Trace))
                Trace();
            ShowFindings();
            ShowPicture();
        }

        private void ShowSettings()
        {
            m_Chains = EditorGUILayout.IntSlider(Content.Chains, m_Chains, WingSkeleton.MinChains, WingSkeleton.MaxChains);
            m_Joints = EditorGUILayout.IntSlider(Content.Joints, m_Joints, WingSkeleton.MinJoints, WingSkeleton.MaxJoints);
            int triangles = EditorGUILayout.IntField(Content.Triangles, m_Triangles);
            m_Triangles = Mathf.Clamp(triangles, WingTracingSettings.MinTriangles, WingTracingSettings.MaxTriangles);
            m_Length = EditorGUILayout.FloatField(Content.Length, m_Length);
            m_Leading = (WingImageSide)EditorGUILayout.EnumPopup(Content.Leading, m_Leading);
            m_VeinWidths = EditorGUILayout.Toggle(Content.VeinWidths, m_VeinWidths);
            m_HasHinge = EditorGUILayout.Toggle(Content.HasHinge, m_HasHinge);
            if (m_HasHinge)
                m_Hinge = EditorGUILayout.Vector2Field(Content.Hinge, m_Hinge);
        }

        private void ShowFindings()
        {
            if (m_Tracing == null)
                return;
            if (m_Tracing.Problem != null)
            {
                EditorGUILayout.HelpBox(m_Tracing.Problem, MessageType.Error);
                return;
            }

            foreach (string warning in m_Tracing.Trace.Warnings)
                EditorGUILayout.HelpBox(warning, MessageType.Warning);
            using (new EditorGUI.DisabledScope(m_IsSaved))
            {
                if (GUILayout.Button(Content.Save))
                    Save();
            }
        }

        private void ShowPicture()
        {
            Rect frame = GUILayoutUtility.GetAspectRect((float)m_Picture.width / m_Picture.height);
            WingTracePreview.Draw(frame, m_Picture, m_Tracing?.Trace);
            Event happened = Event.current;
            if (!m_HasHinge || happened.type != EventType.MouseDown || !frame.Contains(happened.mousePosition))
                return;
            Vector2 at = happened.mousePosition - frame.position;
            m_Hinge = new Vector2(at.x / frame.width * m_Picture.width, at.y / frame.height * m_Picture.height);
            Drop();
            happened.Use();
            Repaint();
        }

        private void Pick(Texture2D image)
        {
            Forget();
            m_Image = image;
            Repaint();
        }

        private void Read()
        {
            try
            {
                m_Picture = WingImageFile.Read(m_Image);
            }
            catch (FormatException problem)
            {
                m_Unreadable = problem.Message;
            }
        }

        private void Trace()
        {
            Drop();
            m_Tracing = WingImageTracing.Run(m_Picture, new WingTracingSettings
            {
                chains = m_Chains,
                jointsPerChain = m_Joints,
                triangles = m_Triangles,
                length = m_Length,
                forward = m_Leading.ToDirection(),
                hinge = m_HasHinge ? m_Hinge : (Vector2?)null,
                veinWidths = m_VeinWidths,
            });
        }

        private void Save()
        {
            m_IsSaved = true;
            EditorGUIUtility.PingObject(WingTraceAssets.Save(m_Tracing.Trace, AssetDatabase.GetAssetPath(m_Image), m_Image.name));
        }

        // A saved skeleton is an asset and lives on.
        private void Drop()
        {
            if (m_Tracing?.Trace != null && !m_IsSaved)
                DestroyImmediate(m_Tracing.Trace.Skeleton);
            m_Tracing = null;
            m_IsSaved = false;
        }

        private void Forget()
        {
            Drop();
            if (m_Picture != null)
                DestroyImmediate(m_Picture);
            m_Picture = null;
            m_Unreadable = null;
        }
    }
}
