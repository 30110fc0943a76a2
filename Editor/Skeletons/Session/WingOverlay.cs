using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Overlay of the active wing: its shape at a phase of the beat, and the colours and weaknesses of its rig. Rebuilt only when the
    /// skeleton, the preset, the selection or a setting has changed. Dispose it.
    /// </summary>
    internal sealed class WingOverlay : IDisposable
    {
        private readonly BeatPreview m_Preview = new BeatPreview();
        private readonly InspectionMesh m_Inspection = new InspectionMesh();
        private readonly AssetWatch<WingSkeleton, SkeletonValue> m_Skeletons = new AssetWatch<WingSkeleton, SkeletonValue>(
            asset => new SkeletonValue(asset));
        private readonly AssetWatch<WingPreset, PresetValues> m_Presets = new AssetWatch<WingPreset, PresetValues>(
            asset => new PresetValues(asset));
        private OverlayKey m_Inspected;
        private OverlayKey m_Coloured;
        private OverlayKey m_Previewed;
        private string m_InspectionRefusal;

        /// <summary>True where the wing's shape at <see cref="Phase"/> is shown.</summary>
        public bool ShowsBeat { get; set; }

        /// <summary>Share of the beat, 0 to 1, 0 at the top of the stroke.</summary>
        public float Phase { get; set; }

        /// <summary>Meaning of the colours over the wing; null for no colours.</summary>
        public RigColourMode? Colours { get; set; }

        /// <summary>The wing at the phase, in the space of its mesh; null where it is not shown.</summary>
        public Mesh BeatMesh => ShowsBeat ? m_Preview.Mesh : null;

        /// <summary>The coloured wing, in the space of its mesh; null where it is not shown.</summary>
        public Mesh ColourMesh => Colours != null && Rig != null ? m_Inspection.Mesh : null;

        /// <summary>The rig as it would be baked; null where there is none.</summary>
        public RigInspection Rig { get; private set; }

        /// <summary>Weaknesses of the rig; empty where it has none or there is no rig.</summary>
        public IReadOnlyList<RigProblem> Problems { get; private set; } = Array.Empty<RigProblem>();

        /// <summary>Parameters of the beat; a monarch's before the first <see cref="Refresh"/>.</summary>
        public WingParameters Parameters { get; private set; } = WingParameters.Default;

        /// <summary>Reason why nothing is shown, one sentence; null where all is shown.</summary>
        public string Refusal { get; private set; }

        /// <summary>Updates the pictures.</summary>
        /// <param name="target">The wing.</param>
        /// <param name="selected">Its selected joints.</param>
        /// <param name="hurries">While joints are dragged: weaknesses are looked for only where colours need the same work.</param>
        public void Refresh(SkeletonTarget target, IReadOnlyList<JointIndex> selected, bool hurries)
        {
            Refusal = target.HasSurface ? null : target.WithoutSurface ?? "There is no mesh to show the rig on.";
            if (!target.HasSurface)
            {
                Rig = null;
                Problems = Array.Empty<RigProblem>();
                m_Inspected = m_Previewed = default;
                m_Preview.Clear();
                return;
            }

            m_Skeletons.Refresh();
            m_Presets.Refresh();
            PresetValues preset = m_Presets.Of(target.Preset);
            Parameters = preset.parameters;
            var key = new OverlayKey(target, m_Skeletons.Of(target.Skeleton).Hash);
            if (!hurries || Colours != null)
                Inspect(target, key);
            Colour(key.With(Colours, selected, preset.Stamp), selected);
            Beat(target, key.With(null, Array.Empty<JointIndex>(), preset.Stamp), preset);
        }

        public void Dispose()
        {
            m_Preview.Dispose();
            m_Inspection.Dispose();
        }

        private void Inspect(SkeletonTarget target, OverlayKey key)
        {
            if (!key.Equals(m_Inspected))
            {
                m_Inspected = key;
                Rig = RigInspection.TryMake(target.Skeleton, target.Surface, WingRigSettings.Default.patchCount, out m_InspectionRefusal);
                Problems = Rig == null ? (IReadOnlyList<RigProblem>)Array.Empty<RigProblem>() : RigProblems.Find(Rig);
            }

            Refusal ??= m_InspectionRefusal;
        }

        private void Colour(OverlayKey key, IReadOnlyList<JointIndex> selected)
        {
            if (Colours == null || Rig == null || key.Equals(m_Coloured))
                return;
            m_Coloured = key;
            m_Inspection.Show(Rig, Colours.Value, selected, Parameters);
        }

        private void Beat(SkeletonTarget target, OverlayKey key, PresetValues preset)
        {
            if (!ShowsBeat)
                return;
            if (!key.Equals(m_Previewed))
            {
                m_Previewed = key;
                m_Preview.Bake(target.Skeleton, target.Surface, PreviewFlight.Of(preset));
            }

            m_Preview.Show(Phase);
            Refusal ??= m_Preview.Problem;
        }
    }
}
