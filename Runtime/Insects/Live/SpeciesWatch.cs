namespace Alate
{
    /// <summary>The presets in use, read once a step. A monarch stands for none.</summary>
    internal sealed class SpeciesWatch : AssetWatch<WingSpecies, SpeciesValues>
    {
        public SpeciesWatch()
            : base(new SpeciesValues(null))
        {
        }

        protected override SpeciesValues Read(WingSpecies species) => new SpeciesValues(species);
    }
}
