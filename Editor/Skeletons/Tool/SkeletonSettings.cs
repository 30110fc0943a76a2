using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Keeps the panel's settings from one session to the next, until the editor is closed.</summary>
    internal static class SkeletonSettings
    {
        private const string k_Mode = "Alate.WingSkeleton.Mode";
        private const string k_Symmetric = "Alate.WingSkeleton.Symmetric";
        private const string k_Labels = "Alate.WingSkeleton.Labels";
        private const string k_Beat = "Alate.WingSkeleton.Beat";
        private const string k_Phase = "Alate.WingSkeleton.Phase";
        private const string k_Colours = "Alate.WingSkeleton.Colours";
        private const int k_NoColours = -1;

        /// <summary>Remembers the settings of a session that ends.</summary>
        public static void Keep(SkeletonSession session)
        {
            SessionState.SetInt(k_Mode, (int)session.Mode);
            SessionState.SetBool(k_Symmetric, session.IsSymmetric);
            SessionState.SetBool(k_Labels, session.ShowsLabels);
            SessionState.SetBool(k_Beat, session.Overlay.ShowsBeat);
            SessionState.SetFloat(k_Phase, session.Overlay.Phase);
            SessionState.SetInt(k_Colours, session.Overlay.Colours.HasValue ? (int)session.Overlay.Colours.Value : k_NoColours);
        }

        /// <summary>Gives a session that begins the settings of the one before; the first keeps its own.</summary>
        public static void Restore(SkeletonSession session)
        {
            session.Mode = (DragMode)SessionState.GetInt(k_Mode, (int)session.Mode);
            session.IsSymmetric = SessionState.GetBool(k_Symmetric, session.IsSymmetric);
            session.ShowsLabels = SessionState.GetBool(k_Labels, session.ShowsLabels);
            session.Overlay.ShowsBeat = SessionState.GetBool(k_Beat, session.Overlay.ShowsBeat);
            session.Overlay.Phase = SessionState.GetFloat(k_Phase, session.Overlay.Phase);
            int colours = SessionState.GetInt(k_Colours, k_NoColours);
            session.Overlay.Colours = colours == k_NoColours ? (RigColourMode?)null : (RigColourMode)colours;
        }
    }
}
