using System;
using System.IO;
using Alate.Flight;
using UnityEditor;
using UnityEngine;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace Alate.Editor
{
    /// <summary>Buttons that record the flight of an insect in play, and save it.</summary>
    internal sealed class RecordingPanel
    {
        private static class Content
        {
            public static readonly GUIContent Record = new GUIContent(
                "Record",
                "Lets the flight start over in a hover on the spot, and writes down all that it meets, so that it can be flown again.");
            public static readonly GUIContent Stop = new GUIContent("Stop", "Ends the recording. It stays until the next one begins.");
            public static readonly GUIContent Save = new GUIContent(
                "Save Recording…", "Writes the recording to a file, which fly --free --replay of the command line flies again.");
        }

        private readonly Func<string, string> m_Ask;
        private string m_Answer = "";

        /// <param name="ask">Returns the path of a file, of a proposed name; empty where it was cancelled. Null asks the user.</param>
        public RecordingPanel(Func<string, string> ask = null) =>
            m_Ask = ask ?? (name => EditorUtility.SaveFilePanel("Recording", "", name, "txt"));

        /// <summary>Draws the panel of an insect in play.</summary>
        public void Draw(InsectFlight flight)
        {
            FlightRecorder recorder = flight.Recorder;
            bool records = flight.IsRecording;
            if (recorder != null)
                EditorGUILayout.LabelField(Told(recorder), EditorStyles.wordWrappedMiniLabel);
            if (m_Answer.Length > 0)
                EditorGUILayout.LabelField(m_Answer, EditorStyles.wordWrappedMiniLabel);
            if (GUILayout.Button(records ? Content.Stop : Content.Record))
            {
                m_Answer = "";
                if (records)
                    flight.StopRecording();
                else
                    flight.StartRecording();
            }

            if (!records && recorder != null && recorder.Recording.Steps.Count > 0 && GUILayout.Button(Content.Save))
                Save(flight);
        }

        private static string Told(FlightRecorder recorder)
        {
            string seconds = FormattableString.Invariant($"{recorder.Recording.Seconds:0.0} s");
            return recorder.Ended == null ? $"Records: {seconds}." : $"Recorded {seconds}; then {recorder.Ended}.";
        }

        private void Save(InsectFlight flight)
        {
            string path = m_Ask(flight.name);
            if (string.IsNullOrEmpty(path))
                return;
            FlightRecording recording = flight.Recorder.Recording;
            recording.Package = PackageInfo.FindForAssembly(typeof(InsectFlight).Assembly)?.version ?? "";
            recording.Options = $"scene of {flight.name}";
            try
            {
                File.WriteAllText(path, RecordingText.Write(recording));
                m_Answer = $"Saved to {path}.";
            }
            catch (Exception failed) when (failed is IOException || failed is UnauthorizedAccessException || failed is ArgumentException)
            {
                m_Answer = failed.Message;
            }
        }
    }
}
