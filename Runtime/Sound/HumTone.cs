namespace Alate.Sound
{
    /// <summary>A tone that is wanted: what the main thread hands to that of the sound.</summary>
    internal sealed class HumTone
    {
        /// <summary>Frequency of the beat as it is heard, hertz.</summary>
        public float frequency;

        /// <summary>Root mean square of the sound, 0 to 1.</summary>
        public float level;

        /// <summary>[overtone − 1] Amplitudes of the overtones, the root mean square of all 1.</summary>
        public readonly float[] amplitudes = new float[BeatSpectrum.Overtones];
    }
}
