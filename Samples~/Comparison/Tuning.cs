using UnityEngine;

namespace Alate.Samples
{
    /// <summary>Values of the sliders: factors on a species' own values, and a wind.</summary>
    internal struct Tuning
    {
        /// <summary>Factors; 1 leaves the species as it is.</summary>
        public float elasticity, delay, amplitude, frequency;

        /// <summary>Head wind, metres per second of the real insect.</summary>
        public float wind;

        /// <summary>The species as it is, in still air.</summary>
        public static Tuning None => new Tuning { elasticity = 1f, delay = 1f, amplitude = 1f, frequency = 1f };

        /// <summary>Writes a species' values, tuned, into a copy.</summary>
        public void Write(WingPreset full, WingPreset tuned)
        {
            tuned.Stiffness.elasticity = full.Stiffness.elasticity * elasticity;
            tuned.Wave.chordDelay = full.Wave.chordDelay * delay;
            tuned.Wave.spanDelay = full.Wave.spanDelay * delay;
            tuned.Beat.flapRange = Scaled(full.Beat.flapRange);
            tuned.Beat.featherRange = Scaled(full.Beat.featherRange);
            tuned.Beat.sweepRange = Scaled(full.Beat.sweepRange);
            tuned.Beat.maxFrequency = full.Beat.maxFrequency * frequency;
        }

        private float Scaled(float range) => Mathf.Min(180f, range * amplitude);
    }
}
