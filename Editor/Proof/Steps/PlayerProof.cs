using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEditor.Build.Reporting;
using UnityEditor.SceneManagement;
using UnityEngine.SceneManagement;

namespace Alate.Proof
{
    /// <summary>Builds a player of one sample for the machine's own platform, and starts it once.</summary>
    internal static class PlayerProof
    {
        public const string Builds = "a player builds", Starts = "the player flies and draws";

        private const string k_Scene = "Garden", k_SavedScene = "Assets/Proof Player.unity", k_Account = "Player";
        private const int k_MostMilliseconds = 180_000;

        /// <summary>Builds and starts.</summary>
        /// <param name="folder">Folder of the step's files.</param>
        public static IEnumerable<ProofLine> Run(string folder)
        {
            BuildTarget target = EditorUserBuildSettings.activeBuildTarget;
            string player = Path.Combine(folder, "player", target == BuildTarget.StandaloneWindows64 ? "Alate.exe" : "Alate");
            SaveScene();
            BuildReport report = BuildPipeline.BuildPlayer(new BuildPlayerOptions
            {
                scenes = new[] { k_SavedScene },
                locationPathName = player,
                target = target,
                options = BuildOptions.None,
            });
            bool built = report.summary.result == BuildResult.Succeeded;
            string measured = $"{report.summary.result}, {report.summary.totalErrors} errors";
            yield return ProofLine.Of(Builds, built, measured, "", target.ToString());
            yield return built ? Start(target == BuildTarget.StandaloneOSX ? InApp(player) : player, folder)
                : ProofLine.NotTried(Starts, "there is no player");
        }

        private static void SaveScene()
        {
            string path = SceneTour.Scenes().Single(scene => Path.GetFileNameWithoutExtension(scene) == k_Scene);
            Scene scene = EditorSceneManager.OpenScene(path);
            SceneTour.AddWitness("", k_Account);
            EditorSceneManager.SaveScene(scene, k_SavedScene);
        }

        private static ProofLine Start(string player, string folder)
        {
            var start = new ProcessStartInfo(player) { UseShellExecute = false };
            foreach (string argument in new[] { "-batchmode", "-logFile", Path.Combine(folder, "player.log"), ProofArguments.Out, folder })
                start.ArgumentList.Add(argument);
            using (var process = Process.Start(start))
            {
                if (!process.WaitForExit(k_MostMilliseconds))
                    process.Kill();
            }

            return SceneTour.Line(folder, k_Account, Starts);
        }

        private static string InApp(string player)
        {
            string app = player.EndsWith(".app") ? player : player + ".app";
            string folder = Path.Combine(app, "Contents", "MacOS");
            return Directory.Exists(folder) ? Directory.GetFiles(folder).First() : player;
        }
    }
}
