using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Alate.Proof
{
    /// <summary>Editor, package, folder and render pipelines of a proof.</summary>
    internal sealed class ProofOptions
    {
        /// <summary>Path of the editor's program.</summary>
        public string Editor = "";

        /// <summary>Folder of the editor's data.</summary>
        public string Contents = "";

        /// <summary>Folder of the package.</summary>
        public string Package = "";

        /// <summary>Version of the package.</summary>
        public string Version = "";

        /// <summary>Folder of projects, logs and report: new or empty, or one of a proof before.</summary>
        public string Out = "";

        /// <summary>Render pipelines in their order.</summary>
        public IReadOnlyList<string> Pipelines = new[] { ProofPipelines.BuiltIn };

        /// <summary>Reason why a proof with these options cannot start, one line; null when it can.</summary>
        public string FindProblem()
        {
            if (!File.Exists(Editor))
                return $"There is no editor at '{Editor}'; give the path of Unity's program.";
            if (!File.Exists(ProofSteps.GoldenPath(Package)))
                return $"There is no package Alate in '{Package}'; its golden flights are missing.";
            if (Pipelines.Count == 0)
                return $"No render pipeline is named; allowed are {string.Join(", ", ProofPipelines.All)}.";
            string unknown = Pipelines.FirstOrDefault(pipeline => !ProofPipelines.All.Contains(pipeline));
            if (unknown != null)
                return $"'{unknown}' is no render pipeline; allowed are {string.Join(", ", ProofPipelines.All)}.";
            string absent = Pipelines.FirstOrDefault(IsAbsent);
            if (absent != null)
                return $"The editor in '{Contents}' comes without the package {ProofPipelines.PackageOf(absent)}; leave out {absent}.";
            return Out.Length == 0 ? "No folder is named for the report." : null;
        }

        /// <summary>Program of an editor: that within its bundle on macOS, else itself.</summary>
        public static string ProgramOf(string editor) =>
            Directory.Exists(editor) ? Path.Combine(editor, "Contents", "MacOS", "Unity") : editor;

        private bool IsAbsent(string pipeline) =>
            ProofPipelines.PackageOf(pipeline) is string package && ProofPipelines.VersionIn(Contents, package) == null;
    }
}
