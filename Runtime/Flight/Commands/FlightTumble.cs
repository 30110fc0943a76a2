namespace Alate.Flight
{
    /// <summary>Tumble of an insect: when, how long and how far.</summary>
    public struct FlightTumble
    {
        /// <summary>Time at which the tumble began, seconds that the insect had flown.</summary>
        public double time;

        /// <summary>Seconds that the tumble lasts, or has lasted so far.</summary>
        public float seconds;

        /// <summary>
        /// Metres of the real insect from where the tumble began to where it ended, or to where the insect has got so far.
        /// </summary>
        public float distance;
    }
}
