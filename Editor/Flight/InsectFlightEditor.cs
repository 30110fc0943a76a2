using System;
using Alate.Flight;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of Insect Flight: what the insect does or why it does not fly, with fixes, and the fields.</summary>
    [CustomEditor(typeof(InsectFlight))]
    [CanEditMultipleObjects]
    internal sealed class InsectFlightEditor : UnityEditor.Editor
    {
        private static class Content
        {
            public static readonly GUIContent AddPilot = new GUIContent(
                "Add Wander Pilot", "Adds a pilot that flies the erratic track of a butterfly about where the insect starts.");
            public static readonly GUIContent TakeBody = new GUIContent(
                "Take A Monarch's Body", "Fills the parts of the body with those of a monarch, at the size of these wings.");
            public static readonly GUIContent BakeTrims = new GUIContent(
                "Bake Trims…", "Finds the steady flights of this insect and the gains that hold it, saves them as an asset and assigns it. "
                    + "Takes about a minute; can be cancelled.");
        }

        private readonly RecordingPanel m_Recording = new RecordingPanel();
        private string m_Answer = "";

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && targets.Length == 1;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            FlightStatus status = FindStatus();
            if (!string.IsNullOrEmpty(status.Message))
                EditorGUILayout.HelpBox(status.Message, status.Kind);
            switch (status.Fault)
            {
                case FlightFault.NoPilot: Offer(Content.AddPilot, status.Fault, FlightFixes.AddPilot); break;
                case FlightFault.NoBody: Offer(Content.TakeBody, status.Fault, FlightFixes.TakeBody); break;
                case FlightFault.NoTrims:
                case FlightFault.OtherNumbers:
                    Offer(Content.BakeTrims, status.Fault, flight => FlightFixes.BakeTrims(flight, FlightFixes.BakeWithBar, AssetPath.Ask));
                    break;
            }

            if (m_Answer.Length > 0)
                EditorGUILayout.LabelField(m_Answer, EditorStyles.wordWrappedMiniLabel);
            if (Application.isPlaying && targets.Length == 1)
                m_Recording.Draw((InsectFlight)target);
            DrawDefaultInspector();
        }

        // Of the first selected insect that has a problem, or the first one.
        private FlightStatus FindStatus()
        {
            foreach (UnityEngine.Object chosen in targets)
            {
                var status = FlightStatus.Of((InsectFlight)chosen);
                if (status.Fault != FlightFault.None)
                    return status;
            }

            return targets.Length == 1 ? FlightStatus.Of((InsectFlight)target) : default;
        }

        // All selected insects with the problem are mended at once.
        private void Offer(GUIContent label, FlightFault fault, Func<InsectFlight, FixOutcome> fix)
        {
            if (!GUILayout.Button(label))
                return;
            Edits.InOneStep(label.text, () =>
            {
                foreach (UnityEngine.Object chosen in targets)
                {
                    if (FlightStatus.Of((InsectFlight)chosen).Fault == fault)
                        m_Answer = fix((InsectFlight)chosen).Message;
                }
            });
            serializedObject.Update();
            GUIUtility.ExitGUI();
        }
    }
}
