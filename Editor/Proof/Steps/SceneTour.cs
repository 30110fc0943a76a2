using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Showcase;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Alate.Proof
{
    /// <summary>
    /// Plays each sample scene for ten seconds and keeps its pictures. Goes on from frame to frame of the editor, and after each reload of
    /// the scripts from what it noted in the session.
    /// </summary>
    internal static class SceneTour
    {
        /// <summary>Seconds of play at which pictures are taken.</summary>
        public static readonly float[] Times = { 1f, 4f, 7f, 10f };

        private const string k_Next = "Alate.Proof.NextScene", k_Deadline = "Alate.Proof.Deadline", k_Folder = "Assets/Samples";
        private const int k_Off = -1;
        private const float k_MostSeconds = 120f;

        /// <summary>Scenes of the imported samples.</summary>
        public static string[] Scenes() => Directory.GetFiles(k_Folder, "*.unity", SearchOption.AllDirectories)
            .Select(path => path.Replace('\\', '/')).OrderBy(path => path, StringComparer.Ordinal).ToArray();

        /// <summary>Claim of the scene of a name.</summary>
        public static string Claim(string scene) => $"{scene} plays for {Times[Times.Length - 1]:0} s without an error";

        /// <summary>Starts with the first scene.</summary>
        public static void Start()
        {
            SessionState.SetInt(k_Next, 0);
            EditorApplication.update += GoOn;
        }

        /// <summary>Puts a camera's witness into the scene that is open.</summary>
        /// <param name="folder">Folder of its pictures and report; empty for that of the player's command line.</param>
        /// <param name="name">Name of the scene.</param>
        public static void AddWitness(string folder, string name)
        {
            SceneWitness witness = new GameObject("Proof").AddComponent<SceneWitness>();
            witness.Folder = folder;
            witness.SceneName = name;
            witness.Times = Times;
        }

        /// <summary>Line of a scene that was played.</summary>
        /// <param name="folder">Folder of its report.</param>
        /// <param name="scene">Its name.</param>
        /// <param name="claim">The claim.</param>
        public static ProofLine Line(string folder, string scene, string claim)
        {
            var account = SceneAccount.Read(folder, scene);
            if (account == null)
                return ProofLine.Of(claim, false, "no report", "", $"it did not end within {k_MostSeconds:0} s");
            string measured = string.Format(
                CultureInfo.InvariantCulture, "{0} frames of {1:0.0} ms, {2} errors", account.frames, account.milliseconds, account.errors);
            bool held = account.errors == 0 && account.pictures == Times.Length && account.blank == 0;
            string note = account.blank > 0 ? $"{account.blank} of {account.pictures} pictures show one colour" : account.firstError;
            return ProofLine.Of(claim, held, measured, "0 errors", note);
        }

        [InitializeOnLoadMethod]
        private static void Resume()
        {
            if (SessionState.GetInt(k_Next, k_Off) != k_Off)
                EditorApplication.update += GoOn;
        }

        private static void GoOn()
        {
            if (EditorApplication.isCompiling || EditorApplication.isUpdating)
                return;
            if (EditorApplication.isPlaying)
            {
                if (SceneWitness.IsDone || EditorApplication.timeSinceStartup > SessionState.GetFloat(k_Deadline, 0f))
                    EditorApplication.ExitPlaymode();
            }
            else if (!EditorApplication.isPlayingOrWillChangePlaymode)
            {
                Next();
            }
        }

        private static void Next()
        {
            string[] scenes = Scenes();
            int next = SessionState.GetInt(k_Next, 0);
            if (next >= scenes.Length)
            {
                EditorApplication.update -= GoOn;
                SessionState.SetInt(k_Next, k_Off);
                ProofSteps.EndScenes(scenes);
                return;
            }

            SessionState.SetInt(k_Next, next + 1);
            SessionState.SetFloat(k_Deadline, (float)EditorApplication.timeSinceStartup + k_MostSeconds);
            EditorSceneManager.OpenScene(scenes[next]);
            AddWitness(ProofSteps.Folder, Path.GetFileNameWithoutExtension(scenes[next]));
            EditorApplication.EnterPlaymode();
        }
    }
}
