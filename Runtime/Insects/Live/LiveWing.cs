using UnityEngine;

namespace Alate
{
    /// <summary>Living wing: its handle in the world of the simulation, and the values last written to it.</summary>
    internal sealed class LiveWing
    {
        public readonly WingRig rig;

        public readonly MeshRenderer renderer;
        public readonly Transform transform;

        /// <summary>Index of the first vertex in the deformed mesh.</summary>
        public readonly int start;

        /// <summary>Parts of the wing's vertices that are computed.</summary>
        public readonly VertexPacking packing;

        /// <summary>True where the ways of the vertices from picture to picture are computed.</summary>
        public readonly bool moves;

        /// <summary>First joint in the world's joint memory; −1 where vertices are computed.</summary>
        public readonly int joint;

        public WingHandle handle;
        public PlacedWing placed;

        /// <summary>Values of the wing's preset.</summary>
        public PresetValues values;

        private Wing m_Wing;
        private WingPreset m_OwnPreset;
        private InsectTuning m_Tuning;
        private int m_Stamp, m_FoldStamp;
        private float m_Amplitude, m_Lead, m_Fold;
        private readonly TemplateKey.WingKey m_Key;
        private readonly SkeletonValue m_Skeleton;

        public LiveWing(Wing wing, SkeletonValue skeleton, MeshTemplate template, int shape, ShownWings shown)
        {
            m_Wing = wing;
            m_Skeleton = skeleton;
            packing = shown.Packing;
            moves = shown.Moves;
            joint = shown.FirstJoint(shape);
            m_Key = new TemplateKey.WingKey(wing, skeleton.Hash);
            renderer = wing.Renderer;
            rig = template.Shapes[shape].Rig;
            start = template.Starts[shape];
            transform = renderer.transform;
        }

        /// <summary>Returns true where the wing in the list is still the one this was built of.</summary>
        public bool IsBuiltOf(Wing listed) =>
            listed != null && ReferenceEquals(listed.Renderer, renderer) && m_Key.Describes(listed, m_Skeleton.Hash);

        /// <summary>Follows another object of the list with equal content: the editor makes new ones when a slider is moved.</summary>
        public void Follow(Wing listed)
        {
            if (ReferenceEquals(listed, m_Wing))
                return;
            listed.Authored = m_Wing.Authored;
            m_Wing = listed;
        }

        /// <summary>Forgets the authored mesh, once the wing shows it again.</summary>
        public void ForgetAuthored() => m_Wing.Authored = null;

        /// <summary>Updates the wing's frame in the world.</summary>
        public void Place()
        {
            if (transform != null)
                placed = new PlacedWing(transform.localToWorldMatrix, rig.Frame);
        }

        /// <summary>Surroundings of the wing in the body's flight, at its last frame in the world.</summary>
        /// <param name="flight">How the body moves.</param>
        /// <param name="pitch">The body's pitch, radians.</param>
        public WingSurroundings Surroundings(in BodyFlight flight, float pitch) =>
            placed.isValid ? flight.Around(placed, values.size.wingLength, values.size.gravityShare, pitch) : default;

        /// <summary>Folds the wing, or lets it beat again.</summary>
        /// <param name="world">Where the wing is.</param>
        /// <param name="fold">0 to 1.</param>
        /// <param name="flies">Whether a flight drives the wings once they are spread.</param>
        public void Fold(WingWorld world, float fold, bool flies)
        {
            if (fold == m_Fold && (fold == 0f || m_Stamp == m_FoldStamp))
                return;
            m_Fold = fold;
            m_FoldStamp = m_Stamp;
            if (fold > 0f)
                world.SetDrive(handle, values.Folded(fold));
            else if (!flies)
                world.ReleaseDrive(handle);
        }

        /// <summary>Lets the next call of <see cref="Fold"/> act whatever it was told before: somebody else has driven the wing.</summary>
        public void ForgetFold() => m_Fold = float.NaN;

        /// <summary>Takes over values of preset and sliders.</summary>
        /// <param name="presets">The presets in use.</param>
        /// <param name="tuning">What the insect says of all its wings.</param>
        /// <param name="parameters">What the wing is to be stepped with.</param>
        /// <returns>Whether anything changed since the last call.</returns>
        public bool ApplyParameters(AssetWatch<WingPreset, PresetValues> presets, in InsectTuning tuning, out WingParameters parameters)
        {
            if (values == null || values.IsForgotten || !ReferenceEquals(m_OwnPreset, m_Wing.Preset)
                || !ReferenceEquals(m_Tuning.preset, tuning.preset))
            {
                m_OwnPreset = m_Wing.Preset;
                values = presets.Of(m_OwnPreset == null ? tuning.preset : m_OwnPreset);
                m_Stamp = -1;
            }

            float amplitude = m_Wing.AmplitudeScale, lead = Mathf.Deg2Rad * m_Wing.PhaseLead;
            bool same = values.Stamp == m_Stamp && amplitude == m_Amplitude && lead == m_Lead && tuning.SameAs(m_Tuning);
            m_Stamp = values.Stamp;
            m_Amplitude = amplitude;
            m_Lead = lead;
            m_Tuning = tuning;
            if (same)
            {
                parameters = default;
                return false;
            }

            parameters = tuning.ParametersOf(values, m_Wing);
            return true;
        }
    }
}
