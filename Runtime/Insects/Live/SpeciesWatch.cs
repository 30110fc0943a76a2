using System.Collections.Generic;

namespace Alate
{
    /// <summary>The presets in use, each read once a step.</summary>
    internal sealed class SpeciesWatch
    {
        private readonly Dictionary<WingSpecies, SpeciesValues> m_Values = new Dictionary<WingSpecies, SpeciesValues>();
        private readonly List<SpeciesValues> m_All = new List<SpeciesValues>();
        private readonly SpeciesValues m_Monarch = new SpeciesValues(null);

        /// <summary>A preset's values; a monarch's for none.</summary>
        public SpeciesValues Of(WingSpecies species)
        {
            if (species is null)
                return m_Monarch;
            if (!m_Values.TryGetValue(species, out SpeciesValues values))
            {
                m_Values.Add(species, values = new SpeciesValues(species));
                m_All.Add(values);
            }

            return values;
        }

        /// <summary>Reads all presets again.</summary>
        public void Refresh()
        {
            foreach (SpeciesValues values in m_All)
                values.Refresh();
        }
    }
}
