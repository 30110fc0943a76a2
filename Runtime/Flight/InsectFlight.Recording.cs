namespace Alate.Flight
{
    /// <summary>Recording of the flight, from its start to where something other than the wings moves the insect.</summary>
    public sealed partial class InsectFlight
    {
        private FlightRecorder m_Recorder;
        private bool m_StartsOver;

        /// <summary>Recording that is under way or was made last; null where there is none.</summary>
        internal FlightRecorder Recorder => m_Recorder;

        /// <summary>True where a recording is under way.</summary>
        internal bool IsRecording => m_Recorder != null && m_Recorder.Ended == null;

        /// <summary>
        /// Begins a recording. The flight starts over where the insect is, hovering, from the next step on: only what has a known start can
        /// be flown again.
        /// </summary>
        internal void StartRecording()
        {
            m_Recorder = new FlightRecorder();
            m_StartsOver = true;
            m_Start = default;
        }

        /// <summary>Ends the recording; it stays until the next one begins.</summary>
        internal void StopRecording() => m_Recorder?.End("it was stopped");
    }
}
