using System;
using System.Collections.Generic;
using System.IO;
using Alate.Catalogue;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// The blinded study: shows pair after pair without names, asks which looks more natural, writes the votes down and, at the end, says
    /// what they mean.
    /// </summary>
    internal sealed class StudyPanel
    {
        // The insects and methods of the paper's study.
        private static readonly string[] s_Species = { "monarch", "firefly", "painted-lichen-moth", "fishfly" };
        private static readonly ComparisonColumn[] s_Methods = { ComparisonColumn.RigidWing, ComparisonColumn.NoWave,
            ComparisonColumn.FullModel };

        private readonly Stage m_Stage;
        private readonly VoteFile m_File = new VoteFile(Path.Combine(Application.persistentDataPath, "Alate comparison votes.csv"));
        private readonly List<string> m_Results = new List<string>();
        private PairStudy m_Study;
        private int m_Shown = -1;

        /// <param name="stage">Where the pairs are shown.</param>
        public StudyPanel(Stage stage)
        {
            m_Stage = stage;
        }

        /// <summary>True while a study is under way or its result is shown.</summary>
        public bool IsOn => m_Study != null;

        /// <summary>True where a study was just left, and the stage is free again.</summary>
        public bool IsLeft { get; set; }

        /// <summary>Begins a session of somebody new.</summary>
        public void Begin()
        {
            m_Study = new PairStudy(s_Species, s_Methods, Guid.NewGuid().ToString("N").Substring(0, 8), new System.Random());
            m_Shown = -1;
            m_Results.Clear();
        }

        /// <summary>Shows the pair whose turn it is.</summary>
        public void Update()
        {
            if (m_Study.IsOver || m_Shown == m_Study.Done)
                return;
            m_Shown = m_Study.Done;
            m_Stage.Show(InsectCatalogue.Find(m_Study.Species), new[] { m_Study.Left, m_Study.Right }, Tuning.None);
        }

        /// <summary>Draws the questions, or the results.</summary>
        /// <param name="panel">Panel between its beginning and its end.</param>
        public void Draw(ScreenPanel panel)
        {
            if (m_Study.IsOver)
                DrawResults(panel);
            else
                DrawQuestion(panel);
            if (!panel.Button("Leave study"))
                return;
            m_Study = null;
            IsLeft = true;
        }

        private void DrawQuestion(ScreenPanel panel)
        {
            panel.Label($"Pair {m_Study.Done + 1} of {m_Study.Count}: which looks more natural?");
            panel.Row(2);
            bool left = panel.Button("Left"), right = panel.Button("Right");
            panel.Label("Take your time; turn the camera as you like.");

            // A pair that is not yet on the stage was not seen.
            if ((left || right) && m_Shown == m_Study.Done)
                Choose(left);
        }

        private void DrawResults(ScreenPanel panel)
        {
            panel.Label("Thank you. Votes of all sessions so far:");
            foreach (string result in m_Results)
                panel.Label(result);
            panel.Label(m_File.Path);
        }

        private void Choose(bool left)
        {
            try
            {
                m_File.Add(m_Study.Choose(left));
                if (m_Study.IsOver)
                    Count();
            }
            catch (Exception failed) when (failed is IOException || failed is UnauthorizedAccessException || failed is FormatException)
            {
                m_Results.Add(failed.Message);
            }
        }

        private void Count()
        {
            List<Vote> votes = m_File.Read();
            m_Results.Add(new PairResult(ComparisonColumn.FullModel, ComparisonColumn.RigidWing, votes).ToString());
            m_Results.Add(new PairResult(ComparisonColumn.FullModel, ComparisonColumn.NoWave, votes).ToString());
            m_Results.Add(new PairResult(ComparisonColumn.NoWave, ComparisonColumn.RigidWing, votes).ToString());
        }
    }
}
