using System;
using System.IO;

namespace Alate.Proof
{
    /// <summary>Makes the project that a proof runs in: this package by its path, its samples, and a render pipeline.</summary>
    internal static class ProofProject
    {
        private const string k_Dependencies = "\"dependencies\": {";

        /// <summary>Makes a project, or makes one that is there new but for its Library.</summary>
        /// <returns>Its folder.</returns>
        public static string Make(ProofOptions options, string pipeline)
        {
            string project = Path.Combine(options.Out, pipeline, "project");
            foreach (string folder in new[] { "Assets", "Packages", "ProjectSettings" })
            {
                string path = Path.Combine(project, folder);
                if (Directory.Exists(path))
                    Directory.Delete(path, true);
                Directory.CreateDirectory(path);
            }

            File.WriteAllText(Path.Combine(project, "Packages", "manifest.json"), Manifest(options, pipeline));
            Copy(Path.Combine(options.Package, "Samples~"), Path.Combine(project, "Assets", "Samples"));
            return project;
        }

        // The package keeps the pins of a hosting project in a manifest of its own; its path differs, and the pipeline comes to it.
        private static string Manifest(ProofOptions options, string pipeline)
        {
            string text = File.ReadAllText(Path.Combine(options.Package, "Packages", "manifest.json"));
            string package = ProofPipelines.PackageOf(pipeline);
            text = text.Replace("\"file:..\"", $"\"file:{options.Package.Replace('\\', '/')}\"");
            if (package == null)
                return text;
            int at = text.IndexOf(k_Dependencies, StringComparison.Ordinal) + k_Dependencies.Length;
            return text.Insert(at, $"\n    \"{package}\": \"{ProofPipelines.VersionIn(options.Contents, package)}\",");
        }

        private static void Copy(string from, string to)
        {
            Directory.CreateDirectory(to);
            foreach (string file in Directory.GetFiles(from))
                File.Copy(file, Path.Combine(to, Path.GetFileName(file)));
            foreach (string folder in Directory.GetDirectories(from))
                Copy(folder, Path.Combine(to, Path.GetFileName(folder)));
        }
    }
}
