using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine;

namespace Alate.Proof
{
    /// <summary>All parts of a proof: report.json, and report.md with its pictures.</summary>
    [Serializable]
    internal sealed class ProofReport
    {
        /// <summary>Version of the package.</summary>
        public string package = "";

        /// <summary>Parts in the order of pipelines and steps.</summary>
        public List<ProofPart> parts = new List<ProofPart>();

        private static readonly Dictionary<ProofState, string> s_States = new Dictionary<ProofState, string>
        {
            [ProofState.Held] = "🟢 held",
            [ProofState.Differs] = "🔴 **differs**",
            [ProofState.NotTried] = "⚪ not tried",
        };

        /// <summary>Number of lines of an outcome.</summary>
        public int Count(ProofState state) => parts.SelectMany(part => part.lines).Count(line => line.state == state);

        /// <summary>Counts of all outcomes, one line.</summary>
        public string Summary =>
            $"{Count(ProofState.Held)} held, {Count(ProofState.Differs)} differ, {Count(ProofState.NotTried)} not tried";

        /// <summary>Writes both files.</summary>
        /// <returns>Path of report.md.</returns>
        public string Write(string folder)
        {
            Directory.CreateDirectory(folder);
            string path = Path.Combine(folder, "report.md");
            File.WriteAllText(Path.Combine(folder, "report.json"), JsonUtility.ToJson(this, true));
            File.WriteAllText(path, Markdown());
            return path;
        }

        /// <summary>Text of report.md.</summary>
        public string Markdown()
        {
            var text = new StringBuilder();
            text.Append($"# Proof of Alate {package}\n\n{Summary}.\n");
            foreach (IGrouping<string, ProofPart> pipeline in parts.GroupBy(part => part.pipeline))
            {
                ProofPart made = pipeline.FirstOrDefault(part => part.editor.Length > 0);
                text.Append($"\n## {pipeline.Key}\n\n{(made == null ? "No editor answered." : $"{made.editor}; {made.machine}.")}\n\n");
                text.Append("| step | claim | outcome | measured | allowed | note |\n|---|---|---|---|---|---|\n");
                foreach (ProofPart part in pipeline)
                {
                    foreach (ProofLine line in part.lines)
                        Append(text, part.step, line);
                }

                foreach (string picture in pipeline.SelectMany(part => part.pictures))
                    text.Append($"\n![{Path.GetFileNameWithoutExtension(picture)}]({picture})\n");
            }

            return text.ToString();
        }

        private static void Append(StringBuilder text, string step, ProofLine line)
        {
            string[] cells = { step, line.what, s_States[line.state], line.measured, line.allowed, line.note };
            text.Append("| ").Append(string.Join(" | ", cells.Select(Cell))).Append(" |\n");
        }

        // A bar would end the cell, and a line feed the table.
        private static string Cell(string text) => text.Replace("|", "\\|").Replace("\r", "").Replace('\n', ' ');
    }
}
