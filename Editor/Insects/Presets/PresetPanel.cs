using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>A button for each preset by which the wings of the selected insect beat, to save it as it is tuned.</summary>
    internal sealed class PresetPanel
    {
        private static class Content
        {
            public const string Tooltip =
                "Saves a copy of this preset in the project, with the wings' amplitude and phase lead and the insect's substeps where they "
                + "differ from it, "
                + "and lets the wings beat by it. They move as before.";

            public static GUIContent Save(string preset) => new GUIContent($"Save '{preset}' As Preset…", Tooltip);
        }

        private readonly PresetSaving m_Saving;

        /// <param name="saving">Does it.</param>
        public PresetPanel(PresetSaving saving)
        {
            m_Saving = saving;
        }

        /// <summary>Draws the next lines of the inspector; none where several insects are selected.</summary>
        /// <returns>Whether a button was pressed.</returns>
        public bool Draw(IReadOnlyList<InsectWings> insects, out FixOutcome outcome)
        {
            outcome = default;
            if (insects.Count != 1 || insects[0] == null)
                return false;
            TunedPreset pressed = null;
            foreach (TunedPreset preset in TunedPreset.Of(insects[0]))
            {
                if (GUILayout.Button(Content.Save(preset.Name)))
                    pressed = preset;
            }

            if (pressed == null)
                return false;
            outcome = m_Saving.Save(insects[0], pressed);
            return true;
        }
    }
}
