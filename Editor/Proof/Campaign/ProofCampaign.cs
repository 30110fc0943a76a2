using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Alate.Proof
{
    /// <summary>
    /// A proof under way: one editor after the other, in one project a render pipeline. Each call of <see cref="Advance"/> returns at once.
    /// </summary>
    internal sealed class ProofCampaign : IDisposable
    {
        private const string k_NoLicence = "No valid Unity Editor license found";
        private const string k_ImportFailed = "the project was not imported";
        private static readonly TimeSpan s_Most = TimeSpan.FromMinutes(60);

        private readonly ProofOptions m_Options;
        private readonly ProofReport m_Report;
        private readonly List<(string pipeline, ProofStep step)> m_Steps;
        private EditorProcess m_Editor;
        private string m_Project;
        private int m_At;

        /// <exception cref="ArgumentException">The options have a problem; the message is that of
        /// <see cref="ProofOptions.FindProblem"/>.</exception>
        public ProofCampaign(ProofOptions options)
        {
            string problem = options.FindProblem();
            if (problem != null)
                throw new ArgumentException(problem);
            m_Options = options;
            m_Report = new ProofReport { package = options.Version };
            m_Steps = options.Pipelines.SelectMany(pipeline => ProofStep.All.Select(step => (pipeline, step))).ToList();
        }

        /// <summary>Share of the steps that are done, 0 to 1.</summary>
        public float Share => (float)m_At / m_Steps.Count;

        /// <summary>Step that is under way, a few words.</summary>
        public string Status => m_At < m_Steps.Count ? $"{m_Steps[m_At].pipeline}: {m_Steps[m_At].step.Name}" : m_Report.Summary;

        /// <summary>Results so far.</summary>
        public ProofReport Report => m_Report;

        /// <summary>Starts the next editor where none runs; takes the result of one that has ended, and writes the report.</summary>
        /// <returns>False after the last step.</returns>
        public bool Advance()
        {
            if (m_At >= m_Steps.Count)
                return false;
            (string pipeline, ProofStep step) = m_Steps[m_At];
            if (m_Editor == null && WasImported(pipeline, step))
            {
                Start(pipeline, step);
                return true;
            }

            if (m_Editor != null && !m_Editor.HasEnded)
                return true;
            m_Report.parts.Add(PartOf(pipeline, step));
            m_Editor?.Dispose();
            m_Editor = null;
            m_At++;
            m_Report.Write(m_Options.Out);
            return m_At < m_Steps.Count;
        }

        /// <summary>Ends the editor that runs.</summary>
        public void Dispose()
        {
            m_Editor?.Dispose();
            m_Editor = null;
        }

        private void Start(string pipeline, ProofStep step)
        {
            if (step == ProofStep.All[0])
                m_Project = ProofProject.Make(m_Options, pipeline);
            File.Delete(step.ResultIn(m_Options.Out, pipeline));
            m_Editor = new EditorProcess(m_Options.Editor, step.Arguments(m_Project, m_Options, pipeline), s_Most);
        }

        // Without the import's own file nothing of the package ran in that project.
        private bool WasImported(string pipeline, ProofStep step) =>
            step == ProofStep.All[0] || File.Exists(ProofStep.All[0].ResultIn(m_Options.Out, pipeline));

        private ProofPart PartOf(string pipeline, ProofStep step)
        {
            string result = step.ResultIn(m_Options.Out, pipeline);

            // Where no editor ran, a file that is there is of an earlier proof.
            ProofPart part = m_Editor == null ? null : step.IsTests ? TestPart(pipeline, step, result) : ProofPart.Read(result);
            if (part != null)
                return part;
            part = new ProofPart { step = step.Name, pipeline = pipeline };
            string reason = m_Editor == null ? k_ImportFailed : ReasonOf(step.LogIn(m_Options.Out, pipeline));
            part.lines.AddRange(step.Claims(m_Options.Package).Select(claim => ProofLine.NotTried(claim, reason)));
            return part;
        }

        private static ProofPart TestPart(string pipeline, ProofStep step, string path)
        {
            ProofLine line = TestResults.Read(path);
            if (line == null)
                return null;
            var part = new ProofPart { step = step.Name, pipeline = pipeline };
            part.lines.Add(line);
            return part;
        }

        private string ReasonOf(string log)
        {
            string text = File.Exists(log) ? File.ReadAllText(log) : "";
            if (text.Contains(k_NoLicence))
                return "the editor has no licence on this machine";
            string error = text.Split('\n').FirstOrDefault(line => line.Contains("error CS"));
            return error != null ? error.Trim() : $"the editor ended with code {m_Editor.ExitCode}; see {Path.GetFileName(log)}";
        }
    }
}
