namespace Alate
{
    /// <summary>The presets in use, read once a step. A monarch stands for none.</summary>
    internal sealed class PresetWatch : AssetWatch<WingPreset, PresetValues>
    {
        public PresetWatch()
            : base(new PresetValues(null))
        {
        }

        protected override PresetValues Read(WingPreset species) => new PresetValues(species);
    }
}
