using System;
using UnityEngine;
using UnityEngine.Serialization;

namespace Alate
{
    /// <summary>
    /// Wing of an insect as authored: its renderer, the part of the mesh that is the wing, its skeleton, and its differences from the other
    /// wings.
    /// </summary>
    [Serializable]
    public sealed class Wing
    {
        /// <summary>Largest factor on the amplitudes, of a wing and of all wings.</summary>
        internal const float MostAmplitude = 2f;

        private const float k_MostLead = 180f;

        [SerializeField]
        [Tooltip("The mesh renderer that draws this wing. Several wings may share one.")]
        private MeshRenderer m_Renderer;

        [SerializeField]
        [Tooltip("Which part of the mesh is the wing. Whole Mesh: all of it. Submesh: the triangles of one material. Connected Part: what "
            + "hangs together with the triangle nearest to the point.")]
        private WingPart m_Part;

        [SerializeField]
        [Tooltip("Number of the submesh that is the wing, from 0. Only with Submesh.")]
        private int m_Submesh;

        [SerializeField]
        [Tooltip("A point on the wing, in the mesh's own units. Only with Connected Part.")]
        private Vector3 m_Point;

        [SerializeField]
        [Tooltip("The wing's radial joint chains, in the space of the mesh. None: they are laid out by themselves when play begins.")]
        private WingSkeleton m_Skeleton;

        [SerializeField]
        [Tooltip("The side of the body that the wing is on.")]
        private WingSide m_Side;

        [SerializeField]
        [Tooltip("Fore wing (or the only pair) or hind wing.")]
        private WingPair m_Pair;

        [SerializeField]
        [Tooltip("A preset of this wing's own; none takes the insect's. For hind wings that are built or driven differently.")]
        [FormerlySerializedAs("m_Species")]
        private WingPreset m_Preset;

        [SerializeField]
        [Range(0f, MostAmplitude)]
        [Tooltip("Factor on the amplitudes, 0 to 2; 1 is the preset's. 0 holds the wing still in the middle of its stroke; beat one side "
            + "harder to roll.")]
        private float m_AmplitudeScale = 1f;

        [SerializeField]
        [Range(-k_MostLead, k_MostLead)]
        [Tooltip(
            "Degrees of the beat by which this wing is ahead of the insect, -180 to 180; 0 beats with it. Added to the preset's own lead.")]
        private float m_PhaseLead;

        // False in the first entry that the inspector adds to an empty list: that is all zeros, whatever is written above.
        [SerializeField, HideInInspector]
        private bool m_IsFilledIn = true;

        // The authored mesh while the wing lives: a clone made meanwhile finds it here even when the original is gone.
        [SerializeField, HideInInspector]
        private Mesh m_Authored;

        /// <summary>Mesh to restore; null while the wing does not live.</summary>
        internal Mesh Authored
        {
            get => m_Authored;
            set => m_Authored = value;
        }

        /// <summary>
        /// Renderer that draws the wing; needs a <see cref="MeshFilter"/> beside it. Several wings may share one renderer, each with a part
        /// of its mesh.
        /// </summary>
        public MeshRenderer Renderer
        {
            get => m_Renderer;
            set => m_Renderer = value;
        }

        /// <summary>Part of the mesh that is the wing.</summary>
        public WingPart Part
        {
            get => m_Part;
            set => m_Part = value;
        }

        /// <summary>Index of the submesh that is the wing, from 0, for <see cref="WingPart.Submesh"/>.</summary>
        public int Submesh
        {
            get => m_Submesh;
            set => m_Submesh = value;
        }

        /// <summary>Point on the wing, mesh space, for <see cref="WingPart.ConnectedPart"/>.</summary>
        public Vector3 Point
        {
            get => m_Point;
            set => m_Point = value;
        }

        /// <summary>Joint chains in the space of the mesh; null lays them out automatically.</summary>
        public WingSkeleton Skeleton
        {
            get => m_Skeleton;
            set => m_Skeleton = value;
        }

        /// <summary>The side of the body.</summary>
        public WingSide Side
        {
            get => m_Side;
            set => m_Side = value;
        }

        /// <summary>Fore or hind wing.</summary>
        public WingPair Pair
        {
            get => m_Pair;
            set => m_Pair = value;
        }

        /// <summary>Preset of this wing alone; null takes the insect's.</summary>
        public WingPreset Preset
        {
            get => m_Preset;
            set => m_Preset = value;
        }

        /// <summary>Factor on the amplitudes, 0 to 2 (clamped).</summary>
        public float AmplitudeScale
        {
            get => NumberRange.Clamp(m_AmplitudeScale, 0f, MostAmplitude, 1f);
            set => m_AmplitudeScale = NumberRange.Clamp(value, 0f, MostAmplitude, 1f);
        }

        /// <summary>Lead of the wing before the insect's beat, degrees, −180 to 180 (clamped).</summary>
        public float PhaseLead
        {
            get => NumberRange.Clamp(m_PhaseLead, -k_MostLead, k_MostLead, 0f);
            set => m_PhaseLead = NumberRange.Clamp(value, -k_MostLead, k_MostLead, 0f);
        }

        /// <summary>Sets the defaults of an entry whose fields are all zero.</summary>
        internal void FillIn()
        {
            if (m_IsFilledIn)
                return;
            m_IsFilledIn = true;
            m_AmplitudeScale = 1f;
        }
    }
}
