using System.Collections.Generic;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Records the loads of the patches of wings while they are drawn, and no longer than the insect is selected.</summary>
    internal static class LoadRecording
    {
        private static readonly HashSet<InsectWings> s_Recorded = new HashSet<InsectWings>();

        static LoadRecording()
        {
            Selection.selectionChanged += StopUnselected;
        }

        /// <summary>Starts or stops recording a wing's loads.</summary>
        public static void Set(InsectWings insect, int wing, bool on)
        {
            WingSystem.Loop.World.RecordPatches(insect.Live.wings[wing].handle, on);
            if (on)
                s_Recorded.Add(insect);
        }

        /// <summary>Stops recording for all insects that are not selected any more.</summary>
        private static void StopUnselected()
        {
            s_Recorded.RemoveWhere(insect =>
            {
                bool stops = insect == null || !IsSelected(insect);
                for (int wing = 0; stops && insect != null && insect.Live != null && wing < insect.Live.wings.Length; wing++)
                    WingSystem.Loop.World.RecordPatches(insect.Live.wings[wing].handle, false);
                return stops;
            });
        }

        /// <summary>Returns true where the gizmos of an insect are drawn: it or an object above it is selected.</summary>
        public static bool IsSelected(InsectWings insect) =>
            System.Array.Exists(Selection.transforms, selected => insect.transform.IsChildOf(selected));
    }
}
