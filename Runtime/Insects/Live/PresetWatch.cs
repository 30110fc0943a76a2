namespace Alate
{
    /// <summary>Presets in use, read once a step. None stands for a monarch's.</summary>
    internal sealed class PresetWatch : AssetWatch<WingPreset, PresetValues>
    {
        public PresetWatch()
            : base(new PresetValues(null))
        {
        }

        protected override PresetValues Read(WingPreset preset) => new PresetValues(preset);
    }
}
