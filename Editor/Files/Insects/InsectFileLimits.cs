using System;
using System.Linq;
using Alate.Catalogue;

namespace Alate.Files
{
    /// <summary>Limits of what the model makes of several numbers of an insect file together.</summary>
    internal static class InsectFileLimits
    {
        /// <summary>Checks all wings in all variants.</summary>
        /// <exception cref="FormatException">The model would take another number; the message has the wing and the range.</exception>
        public static void Check(InsectDefinition insect, JsonPlace root)
        {
            foreach (WingDefinition wing in insect.Wings)
            {
                foreach (InsectVariant variant in wing.Variants)
                {
                    WingPreset preset = wing.CreatePreset(variant: variant);
                    string problem = Problem("airDensity", preset.Size.RelativeDensity, "fluid density times length³ over mass")
                        ?? Problem("referenceFrequency", preset.ReferenceFrequency,
                            "beat with the top speed over the speed of the tip, Hz,");
                    bool isHeavy = 2 * insect.Wings.Count * preset.Size.wingMass >= preset.Size.insectMass;
                    UnityEngine.Object.DestroyImmediate(preset);
                    JsonPlace place = root[InsectKeys.Wings]?[wing.Name] ?? root;
                    if (problem != null)
                        throw place.Wrong($"the {wing.Name} of the variant {InsectKeys.Word(variant)}: {problem}");
                    if (isHeavy)
                    {
                        throw place.Wrong(
                            $"the wings of the variant {InsectKeys.Word(variant)} weigh as much as the whole insect, or more");
                    }
                }
            }
        }

        private static string Problem(string name, float value, string words)
        {
            WingParameterRange range = WingParameterRange.All.First(one => one.Name == name);
            return range.Contains(value)
                ? null
                : FormattableString.Invariant($"{words} is {value:G4}; {range.Minimum:G4} to {range.Maximum:G4} is allowed");
        }
    }
}
