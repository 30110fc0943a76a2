namespace Alate.Editor
{
    /// <summary>Saves a tuned preset as an asset of the project and lets the wings beat by it.</summary>
    internal sealed class PresetSaving
    {
        private const string k_UndoName = "Save Preset";
        private readonly AskForPath m_Ask;

        /// <param name="ask">Where to save it.</param>
        public PresetSaving(AskForPath ask)
        {
            m_Ask = ask;
        }

        /// <summary>Asks for a path, saves and assigns the preset. Undo reverts the assignment; the asset stays.</summary>
        public FixOutcome Save(InsectWings insect, TunedPreset preset)
        {
            string path = m_Ask(
                "Save Wing Preset", AssetPath.FileName($"{insect.name} {preset.Name}"), "Choose where the preset is saved.");
            if (string.IsNullOrEmpty(path))
                return FixOutcome.Refused("");
            string obstacle = AssetPath.FindProblem(path);
            if (obstacle != null)
                return FixOutcome.Refused(obstacle);
            WingPreset saved = AssetWriter.Save(preset.Copy(), path, k_UndoName);
            Edits.Change(insect, k_UndoName, _ => preset.Use(saved));
            return FixOutcome.Done($"Saved as '{path}'; the wings beat by it now.");
        }
    }
}
