using System;
using System.Collections.Generic;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// One column of the paper's comparisons (Fig. 14, and methods I to III of its user study): the same wing by a model with parts left
    /// out, or of another elasticity.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class ComparisonColumn
    {
        /// <summary>
        /// Elasticity of the last column of <see cref="All"/>, as a factor on that of the species: 0.25, soft enough to see.
        /// </summary>
        public const float OtherElasticity = 0.25f;

        private readonly Action<WingPreset> m_Change;

        private ComparisonColumn(string name, string title, string description, Action<WingPreset> change)
        {
            Name = name;
            Title = title;
            Description = description;
            m_Change = change;
        }

        /// <summary>
        /// Flat wings that flap, feather and sweep as the wings' roots are driven, as in earlier models of flight: neither wave nor
        /// bending.
        /// </summary>
        public static ComparisonColumn RigidWing { get; } = new ComparisonColumn(
            "rigid", "Rigid wing", "as in earlier flight models: flapping, feathering and sweeping of a flat plate", MakeRigid);

        /// <summary>Full model without the deformation wave: every part of the wing is driven at once.</summary>
        public static ComparisonColumn NoWave { get; } = new ComparisonColumn(
            "no-wave", "No deformation wave", "bending and elasticity alone: every part of the wing is driven at once", StopWave);

        /// <summary>Full model, unchanged.</summary>
        public static ComparisonColumn FullModel { get; } = new ComparisonColumn(
            "full", "Full model", "deformation wave, bending and elasticity", _ => { });

        /// <summary>
        /// The four columns from the least to the most flexible: rigid, no wave, full, and full with <see cref="OtherElasticity"/>.
        /// </summary>
        public static IReadOnlyList<ComparisonColumn> All { get; } = new[] { RigidWing, NoWave, FullModel, Elasticity(OtherElasticity) };

        /// <summary>A short name for tables and files: "rigid", "no-wave", "full", "elasticity-0.25".</summary>
        public string Name { get; }

        /// <summary>Display name.</summary>
        public string Title { get; }

        /// <summary>Description of what the column leaves out or changes, in a few words that follow the title.</summary>
        public string Description { get; }

        /// <summary>The full model with another elasticity.</summary>
        /// <param name="factor">Factor on the species' k_e, 10⁻⁶ to 10⁶; below 1 is softer.</param>
        /// <exception cref="ArgumentOutOfRangeException">The factor is out of its range or not a number.</exception>
        public static ComparisonColumn Elasticity(float factor)
        {
            const float k_Least = 1e-6f, k_Most = 1e6f;
            if (!(factor >= k_Least && factor <= k_Most))
            {
                throw new ArgumentOutOfRangeException(
                    nameof(factor), factor,
                    FormattableString.Invariant($"The factor on the elasticity must be between {k_Least} and {k_Most}."));
            }

            return new ComparisonColumn(
                FormattableString.Invariant($"elasticity-{factor}"), FormattableString.Invariant($"Elasticity × {factor}"),
                factor < 1f ? "the full model, softer" : "the full model, stiffer", preset => preset.Stiffness.elasticity *= factor);
        }

        /// <summary>Makes a copy of a preset with the changes of this column; the caller destroys it.</summary>
        /// <exception cref="ArgumentNullException">There is no preset.</exception>
        public WingPreset CreatePreset(WingPreset full)
        {
            if (full == null)
                throw new ArgumentNullException(nameof(full));
            WingPreset copy = UnityEngine.Object.Instantiate(full);
            copy.name = $"{full.name} ({Name})";
            m_Change(copy);
            return copy;
        }

        /// <summary>
        /// Copies the values of a preset into an earlier copy, with the changes of this column, so that one slider moves all columns.
        /// </summary>
        /// <param name="full">The preset; it stays as it is.</param>
        /// <param name="copy">What <see cref="CreatePreset"/> returned; living wings are told.</param>
        /// <exception cref="ArgumentNullException">One of them is missing.</exception>
        /// <exception cref="ArgumentException">Both are the same.</exception>
        public void Refresh(WingPreset full, WingPreset copy)
        {
            if (full == null)
                throw new ArgumentNullException(nameof(full));
            if (copy == null)
                throw new ArgumentNullException(nameof(copy));
            if (copy == full)
                throw new ArgumentException($"'{full.name}' cannot be its own copy.", nameof(copy));
            copy.Size = full.Size;
            copy.Beat = full.Beat;
            copy.Wave = full.Wave;
            copy.Stiffness = full.Stiffness;
            copy.Kinematics = full.Kinematics;
            copy.SubstepsPerBeat = full.SubstepsPerBeat;
            copy.Options = full.Options;
            m_Change(copy);
        }

        /// <inheritdoc/>
        public override string ToString() => Title;

        private static void MakeRigid(WingPreset preset)
        {
            StopWave(preset);
            preset.Wave.rootShare = 1f;
            preset.Stiffness.jointLimit = 0f;
        }

        private static void StopWave(WingPreset preset)
        {
            preset.Wave.chordDelay = 0f;
            preset.Wave.spanDelay = 0f;
        }
    }
}
