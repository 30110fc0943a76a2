using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Shows the insects of open scenes and stages that ask for a preview in their poses. Fields are read for each picture: what an
    /// Animation window or Timeline has written is shown.
    /// </summary>
    [InitializeOnLoad]
    internal static class BeatScrubbing
    {
        private static readonly Dictionary<InsectWings, PosedInsect> s_Posed = new Dictionary<InsectWings, PosedInsect>();

        // The engine may validate while it loads, on a thread of its own.
        private static readonly ConcurrentQueue<InsectWings> s_Validated = new ConcurrentQueue<InsectWings>();

        static BeatScrubbing()
        {
            InsectWings.Validated += s_Validated.Enqueue;
            EditorApplication.update += Refresh;
            EditorApplication.delayCall += LookAtAll;
            EditorApplication.playModeStateChanged += OnPlayModeChanged;
            AssemblyReloadEvents.beforeAssemblyReload += Clear;
        }

        /// <summary>Poses that are kept.</summary>
        public static IReadOnlyCollection<PosedInsect> All => s_Posed.Values;

        /// <summary>Begins the preview of an insect that asks for it.</summary>
        private static void Look(InsectWings insect)
        {
            bool isWanted = insect.Preview.shows && !Application.isPlaying && !EditorApplication.isPlayingOrWillChangePlaymode
                && insect.gameObject.scene.IsValid();
            if (isWanted && !s_Posed.ContainsKey(insect))
                s_Posed.Add(insect, new PosedInsect(insect));
        }

        /// <summary>Brings all poses up to date, and ends those that nobody asks for.</summary>
        public static void Refresh()
        {
            while (s_Validated.TryDequeue(out InsectWings validated))
            {
                if (validated != null)
                    Look(validated);
            }

            if (s_Posed.Count == 0)
                return;
            foreach (InsectWings insect in s_Posed.Keys.ToList())
            {
                PosedInsect posed = s_Posed[insect];
                if (posed.IsWanted)
                {
                    posed.Refresh();
                    continue;
                }

                posed.Dispose();
                s_Posed.Remove(insect);
            }
        }

        /// <summary>Ends all; the authored meshes are shown.</summary>
        public static void Clear()
        {
            foreach (PosedInsect posed in s_Posed.Values)
                posed.Dispose();
            s_Posed.Clear();
        }

        // Those that were loaded before this was there, or with play.
        private static void LookAtAll()
        {
            foreach (InsectWings insect in Resources.FindObjectsOfTypeAll<InsectWings>())
                Look(insect);
        }

        private static void OnPlayModeChanged(PlayModeStateChange change)
        {
            if (change == PlayModeStateChange.ExitingEditMode)
                Clear();
            else if (change == PlayModeStateChange.EnteredEditMode)
                LookAtAll();
        }
    }
}
