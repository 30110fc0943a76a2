using System.Collections.Generic;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Wakes of insects while they are drawn: no longer than the insect plays, is selected and shows this layer.</summary>
    internal static class WakeGizmo
    {
        private static readonly Dictionary<InsectWings, InsectWake> s_Wakes = new Dictionary<InsectWings, InsectWake>();

        static WakeGizmo()
        {
            Selection.selectionChanged += DropUnselected;
            EditorApplication.playModeStateChanged += _ => DropAll();
            AssemblyReloadEvents.beforeAssemblyReload += DropAll;
        }

        /// <summary>Draws the wake of an insect in play, and does its next step.</summary>
        public static void Draw(InsectWings insect, IGizmoPen pen)
        {
            if (!s_Wakes.TryGetValue(insect, out InsectWake wake))
                s_Wakes.Add(insect, wake = new InsectWake());
            wake.Follow(insect);
            wake.Draw(insect, pen);
        }

        /// <summary>Drops the wake of an insect; does nothing where it has none.</summary>
        public static void Drop(InsectWings insect)
        {
            if (s_Wakes.TryGetValue(insect, out InsectWake wake))
                wake.Dispose();
            s_Wakes.Remove(insect);
        }

        private static void DropUnselected()
        {
            foreach (InsectWings insect in new List<InsectWings>(s_Wakes.Keys))
            {
                if (insect == null || !LoadRecording.IsSelected(insect))
                    Drop(insect);
            }
        }

        private static void DropAll()
        {
            foreach (InsectWings insect in new List<InsectWings>(s_Wakes.Keys))
                Drop(insect);
        }
    }
}
