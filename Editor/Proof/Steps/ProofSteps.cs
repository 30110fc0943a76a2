using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Alate.Proof
{
    /// <summary>
    /// Work of an editor that a proof has started, a method a step: <c>-executeMethod Alate.Proof.ProofSteps.Golden</c>. Each leaves a
    /// file with its lines and ends the editor.
    /// </summary>
    internal static class ProofSteps
    {
        public const string ImportName = "import", GoldenName = "golden", TimesName = "times";
        public const string ScenesName = "scenes", PlayerName = "player";

        public const string Imports = "all samples import";

        private const string k_Pictures = "*.png";

        /// <summary>Folder of the files of a pipeline.</summary>
        public static string Folder =>
            Path.Combine(ProofArguments.Value(ProofArguments.Out), ProofArguments.Value(ProofArguments.Pipeline));

        /// <summary>Path of the golden file in a package.</summary>
        public static string GoldenPath(string package) => Path.Combine(package, "Editor", "Proof", "Data~", "golden.bin");

        /// <summary>Sets the pipeline, and counts the scenes of the samples.</summary>
        public static void Import() => Run(ImportName, part =>
        {
            string[] wanted = Directory.GetDirectories(Path.Combine(ProofArguments.Value(ProofArguments.Package), "Samples~"));
            int found = SceneTour.Scenes().Length;
            part.lines.Add(ProofLine.Of(Imports, found == wanted.Length, $"{found} scenes", $"{wanted.Length} scenes"));
            part.lines.Add(ProofPipelines.Set(part.pipeline));
        });

        /// <summary>Compares what this editor computes with the golden file.</summary>
        public static void Golden() => Run(GoldenName, part =>
        {
            using (FileStream file = File.OpenRead(GoldenPath(ProofArguments.Value(ProofArguments.Package))))
                part.lines.AddRange(GoldenComparison.Lines(GoldenFile.Read(file), GoldenScenes.Run()));
        });

        /// <summary>Times frames.</summary>
        public static void Times() => Run(TimesName, part => part.lines.AddRange(FrameTimes.Measure()));

        /// <summary>Begins to play the scenes of the samples.</summary>
        public static void Scenes() => SceneTour.Start();

        /// <summary>Writes the lines of scenes that were played.</summary>
        public static void EndScenes(IEnumerable<string> scenes) => Run(ScenesName, part =>
        {
            foreach (string name in scenes.Select(Path.GetFileNameWithoutExtension))
                part.lines.Add(SceneTour.Line(Folder, name, SceneTour.Claim(name)));
            AddPictures(part, _ => true);
        });

        /// <summary>Builds a player and starts it.</summary>
        public static void Player() => Run(PlayerName, part =>
        {
            part.lines.AddRange(PlayerProof.Run(Folder));
            AddPictures(part, picture => Path.GetFileName(picture).StartsWith("Player ", StringComparison.Ordinal));
        });

        private static void AddPictures(ProofPart part, Func<string, bool> belongs)
        {
            IEnumerable<string> names = Directory.GetFiles(Folder, k_Pictures).Where(belongs).OrderBy(path => path, StringComparer.Ordinal);
            part.pictures.AddRange(names.Select(path => $"{part.pipeline}/{Uri.EscapeDataString(Path.GetFileName(path))}"));
        }

        // An exception is the line that is missing: the steps after this one go on.
        private static void Run(string step, Action<ProofPart> work)
        {
            var part = new ProofPart
            {
                step = step,
                pipeline = ProofArguments.Value(ProofArguments.Pipeline),
                editor = $"Unity {Application.unityVersion}",
                machine = $"{SystemInfo.operatingSystem}, {SystemInfo.processorType}, {SystemInfo.graphicsDeviceName}",
            };
            int code = 0;
            try
            {
                work(part);
            }
            catch (Exception problem)
            {
                Debug.LogException(problem);
                part.lines.Add(ProofLine.Of($"step {step}", false, problem.GetType().Name, "", problem.Message));
                code = 1;
            }

            part.Write(ProofArguments.Value(ProofArguments.Out));
            EditorApplication.Exit(code);
        }
    }
}
