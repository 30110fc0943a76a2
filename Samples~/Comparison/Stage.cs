using System.Collections.Generic;
using Alate.Catalogue;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>The columns that are shown, side by side and in step.</summary>
    internal sealed class Stage
    {
        private const float k_Spacing = 1.4f;

        private readonly List<Stand> m_Stands = new List<Stand>();
        private readonly Transform m_Place;
        private WingPreset[] m_Full = new WingPreset[0], m_Tuned = new WingPreset[0];

        /// <param name="place">The middle; insects fly ahead of it.</param>
        public Stage(Transform place)
        {
            m_Place = place;
        }

        /// <summary>Stands from left to right.</summary>
        public IReadOnlyList<Stand> Stands => m_Stands;

        /// <summary>Shows a species in some columns, from left to right.</summary>
        public void Show(InsectDefinition species, IReadOnlyList<ComparisonColumn> columns, in Tuning tuning)
        {
            Clear();
            m_Full = new WingPreset[species.Wings.Count];
            for (int k = 0; k < m_Full.Length; k++)
                m_Full[k] = species.Wings[k].CreatePreset();
            m_Tuned = System.Array.ConvertAll(m_Full, preset => Object.Instantiate(preset));
            foreach (ComparisonColumn column in columns)
                m_Stands.Add(new Stand(column, species, m_Full, m_Place));
            Solo(-1);
            Tune(tuning);
        }

        /// <summary>Shows one column alone; −1 shows all.</summary>
        public void Solo(int solo)
        {
            for (int k = 0; k < m_Stands.Count; k++)
                m_Stands[k].Show(solo < 0 || solo == k, solo < 0 ? k_Spacing * (k - 0.5f * (m_Stands.Count - 1)) : 0f);
        }

        /// <summary>Takes over what the sliders say.</summary>
        public void Tune(in Tuning tuning)
        {
            for (int k = 0; k < m_Full.Length; k++)
                tuning.Write(m_Full[k], m_Tuned[k]);
            foreach (Stand stand in m_Stands)
                stand.Tune(m_Tuned, tuning.wind);
        }

        /// <summary>Lets time go by, seconds.</summary>
        public void Step(float dt)
        {
            foreach (Stand stand in m_Stands)
                stand.Step(dt);
        }

        /// <summary>Ends all.</summary>
        public void Clear()
        {
            foreach (Stand stand in m_Stands)
                stand.Destroy();
            m_Stands.Clear();
            foreach (WingPreset preset in m_Full)
                Object.Destroy(preset);
            foreach (WingPreset preset in m_Tuned)
                Object.Destroy(preset);
        }
    }
}
