using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace Alate.Proof
{
    /// <summary>Proves the package in this editor's version: starts editors in projects of their own, and shows what came out.</summary>
    internal sealed class ProofWindow : EditorWindow
    {
        private static class Content
        {
            public const string Menu = "Window/Alate/Proof";
            public const string Title = "Proof";
            public const string About =
                "Imports the package with all samples into new projects, runs its tests, compares its flights with those of the headless "
                + "build, times crowds, plays the sample scenes and a player, and writes a report. Takes half an hour a pipeline; this "
                + "editor can be used meanwhile.";

            public const string NoPackage = "The package is not installed as one: Proof needs its folder.";
            public const string Folder = "Folder";
            public const string Choose = "Folder of projects and report";
            public const string Start = "Prove";
            public const string Stop = "Stop";
            public const string Open = "Show Report";
            public static readonly GUIContent Browse = new GUIContent("...", "Chooses the folder of projects, logs and report.");
        }

        private const float k_BrowseWidth = 28f, k_BarHeight = 20f;

        [SerializeField] private string m_Folder = "";
        [SerializeField] private bool[] m_Chosen = { true, false, false };

        private ProofCampaign m_Campaign;
        private string m_Problem, m_Report;

        [MenuItem(Content.Menu, false, 3100)]
        private static void Open() => GetWindow<ProofWindow>(Content.Title);

        private void OnEnable()
        {
            if (m_Folder.Length == 0)
                m_Folder = Path.GetFullPath(Path.Combine(Application.dataPath, "..", "..", "AlateProof"));
        }

        // A reload of scripts forgets the campaign: its editor must not go on alone.
        private void OnDisable() => Stop();

        private void Update()
        {
            if (m_Campaign == null)
                return;
            string before = m_Campaign.Status;
            bool goesOn = m_Campaign.Advance();
            if (m_Campaign.Status != before)
                Repaint();
            if (goesOn)
                return;
            m_Report = Path.Combine(m_Folder, "report.md");
            Stop();
            Repaint();
        }

        private void OnGUI()
        {
            EditorGUILayout.HelpBox(Content.About, MessageType.None);
            using (new EditorGUI.DisabledScope(m_Campaign != null))
                ShowOptions();
            if (m_Campaign != null)
                ShowProgress();
            else if (GUILayout.Button(Content.Start))
                Begin();
            if (m_Problem != null)
                EditorGUILayout.HelpBox(m_Problem, MessageType.Error);
            if (m_Report != null && GUILayout.Button(Content.Open))
                EditorUtility.RevealInFinder(m_Report);
        }

        private void ShowOptions()
        {
            for (int k = 0; k < m_Chosen.Length; k++)
                m_Chosen[k] = EditorGUILayout.Toggle(ProofPipelines.All[k], m_Chosen[k]);
            using (new EditorGUILayout.HorizontalScope())
            {
                m_Folder = EditorGUILayout.TextField(Content.Folder, m_Folder);
                if (!GUILayout.Button(Content.Browse, GUILayout.Width(k_BrowseWidth)))
                    return;
                string chosen = EditorUtility.OpenFolderPanel(Content.Choose, m_Folder, "");
                if (!string.IsNullOrEmpty(chosen))
                    m_Folder = chosen;
                GUIUtility.ExitGUI();
            }
        }

        private void ShowProgress()
        {
            EditorGUI.ProgressBar(EditorGUILayout.GetControlRect(false, k_BarHeight), m_Campaign.Share, m_Campaign.Status);
            if (GUILayout.Button(Content.Stop))
                Stop();
        }

        private void Begin()
        {
            m_Report = null;
            var package = PackageInfo.FindForAssembly(typeof(ProofWindow).Assembly);
            if (package == null)
            {
                m_Problem = Content.NoPackage;
                return;
            }

            var options = new ProofOptions
            {
                Editor = ProofOptions.ProgramOf(EditorApplication.applicationPath),
                Contents = EditorApplication.applicationContentsPath,
                Package = package.resolvedPath,
                Version = package.version,
                Out = m_Folder,
                Pipelines = ProofPipelines.All.Where((_, k) => m_Chosen[k]).ToList(),
            };
            m_Problem = options.FindProblem();
            if (m_Problem == null)
                m_Campaign = new ProofCampaign(options);
        }

        private void Stop()
        {
            m_Campaign?.Dispose();
            m_Campaign = null;
        }
    }
}
