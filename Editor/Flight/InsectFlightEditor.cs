using Alate.Flight;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of Insect Flight: what the insect does or why it does not fly, a pilot at the press of a button, and the fields.</summary>
    [CustomEditor(typeof(InsectFlight))]
    internal sealed class InsectFlightEditor : UnityEditor.Editor
    {
        private static class Content
        {
            public const string NoTrims = "Does not fly: it has no trims. Take an insect of the menu GameObject > Alate > Flying, or bake trims.";
            public const string OtherNumbers = "Does not fly: its trims were made for other numbers of preset or body. Take the preset of the variant Flight, or bake trims.";
            public const string BadBody = "Does not fly: its masses or the parts of its body are not possible; see the console.";
            public const string NoPilot = "No pilot: the insect keeps the velocity that a script sets. Add a Wander Pilot to let it fly about.";

            public static readonly GUIContent AddPilot = new GUIContent("Add Wander Pilot", "Adds a pilot that flies the erratic track of a butterfly around the insect.");
        }

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            var flight = (InsectFlight)target;
            if (flight.Problem != FlightProblem.None)
                EditorGUILayout.HelpBox(MessageOf(flight.Problem), MessageType.Warning);
            else if (Application.isPlaying)
                EditorGUILayout.HelpBox($"{flight.State}, {flight.BodyVelocity.magnitude:0.00} m/s, aid {1000f * flight.AidPower:0.00} mW", MessageType.Info);
            if (flight.Pilot == null && !flight.TryGetComponent(out FlightPilot _))
            {
                EditorGUILayout.HelpBox(Content.NoPilot, MessageType.Info);
                if (GUILayout.Button(Content.AddPilot))
                    AddPilot(flight);
            }

            DrawDefaultInspector();
        }

        private static void AddPilot(InsectFlight flight)
        {
            Undo.AddComponent<WanderPilot>(flight.gameObject).StayAroundStart();
        }

        private static string MessageOf(FlightProblem problem)
        {
            switch (problem)
            {
                case FlightProblem.OtherNumbers: return Content.OtherNumbers;
                case FlightProblem.BadBody: return Content.BadBody;
                default: return Content.NoTrims;
            }
        }
    }
}
