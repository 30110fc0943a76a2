using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Preset with the tuning of the wings that use it: its own values and the changes to them. Amplitude, phase lead and substeps go into
    /// the copy where they are equal on all these wings, so that the wings beat by it as before.
    /// </summary>
    internal sealed class TunedPreset
    {
        private const float k_LargestRange = 180f, k_LargestLead = 180f;

        private readonly InsectWings m_Insect;
        private readonly List<int> m_Wings = new List<int>();

        private TunedPreset(InsectWings insect, WingPreset source)
        {
            m_Insect = insect;
            Source = source;
        }

        /// <summary>Preset that was tuned; null stands for the monarch's that wings without one have.</summary>
        public WingPreset Source { get; }

        /// <summary>Places in the insect's list of the wings that beat by it.</summary>
        public IReadOnlyList<int> Wings => m_Wings;

        /// <summary>Display name.</summary>
        public string Name => Source == null ? "Monarch" : Source.name;

        /// <summary>The presets by which an insect's wings beat, its own first; one at least.</summary>
        public static List<TunedPreset> Of(InsectWings insect)
        {
            var presets = new List<TunedPreset> { new TunedPreset(insect, insect.Preset) };
            for (int w = 0; w < insect.Wings.Count; w++)
            {
                if (insect.Wings[w] == null)
                    continue;
                WingPreset source = SourceOf(insect, insect.Wings[w]);
                TunedPreset preset = presets.Find(known => known.Source == source);
                if (preset == null)
                    presets.Add(preset = new TunedPreset(insect, source));
                preset.m_Wings.Add(w);
            }

            return presets;
        }

        /// <summary>Makes a copy with the current values; the caller saves or destroys it.</summary>
        public WingPreset Copy()
        {
            WingPreset copy = Source == null ? ScriptableObject.CreateInstance<WingPreset>() : Object.Instantiate(Source);
            copy.name = Name;
            Scale(copy, Share);
            copy.Beat.phaseLead = Wrap(copy.Beat.phaseLead + Lead);
            int substeps = m_Insect.SubstepsPerBeat;
            if (substeps > 0)
                copy.SubstepsPerBeat = substeps;
            return copy;
        }

        /// <summary>
        /// Assigns a copy to the wings: removes the changes that it contains from the wings, and from the insect when no other wings need
        /// them.
        /// </summary>
        public void Use(WingPreset copy)
        {
            float share = Share, lead = Lead;
            if (Source == m_Insect.Preset)
                m_Insect.Preset = copy;
            foreach (int w in m_Wings)
            {
                Wing wing = m_Insect.Wings[w];
                if (wing.Preset != null)
                    wing.Preset = copy;
                wing.AmplitudeScale = share > 0f ? wing.AmplitudeScale / share : 1f;
                wing.PhaseLead -= lead;
            }

            if (m_Wings.Count == m_Insect.Wings.Count)
                m_Insect.Quality.substepsPerBeat = 0;
        }

        // How much of the wings' amplitude goes into the preset: ranges end at half a turn.
        private float Share
        {
            get
            {
                float scale = Common(wing => wing.AmplitudeScale, 1f);
                PresetBeat beat = Source == null ? PresetBeat.Default : Source.Beat;
                float widest = math.max(beat.flapRange, math.max(beat.featherRange, beat.sweepRange));
                return widest > 0f ? math.min(scale, k_LargestRange / widest) : 1f;
            }
        }

        private float Lead => Common(wing => wing.PhaseLead, 0f);

        private float Common(System.Func<Wing, float> value, float otherwise)
        {
            if (m_Wings.Count == 0)
                return otherwise;
            float first = value(m_Insect.Wings[m_Wings[0]]);
            foreach (int w in m_Wings)
            {
                if (value(m_Insect.Wings[w]) != first)
                    return otherwise;
            }

            return first;
        }

        // Stiffness and the strongest wind are measured against the reference frequency, which knows the range: they are kept as they were.
        private static void Scale(WingPreset preset, float share)
        {
            float before = preset.ReferenceFrequency;
            preset.Beat.flapRange *= share;
            preset.Beat.featherRange *= share;
            preset.Beat.sweepRange *= share;
            float ratio = before / preset.ReferenceFrequency;
            preset.Stiffness.leadingEdge *= ratio;
            preset.Stiffness.trailingEdge *= ratio;
            preset.Stiffness.anchor *= ratio;
            preset.Stiffness.springScale *= ratio * ratio;
            preset.Stiffness.strongestWind *= share > 0f ? ratio / share : 1f;
        }

        private static float Wrap(float degrees)
        {
            float whole = 2f * k_LargestLead;
            return degrees > k_LargestLead ? degrees - whole : degrees < -k_LargestLead ? degrees + whole : degrees;
        }

        private static WingPreset SourceOf(InsectWings insect, Wing wing) => wing.Preset == null ? insect.Preset : wing.Preset;
    }
}
