using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// The radial skeleton of one wing (Sec. 4.1 of the paper): chains of joints from the base to the outline, all with the same
    /// number of joints, ordered from the leading edge (chain 0, the principal chain) to the trailing edge.
    /// </summary>
    /// <remarks>
    /// Positions are in the space of the wing's mesh, in its units. The side of <c>cross(span, up)</c> on which the principal chain
    /// lies is the wing's forward side, so that the skeleton of a left wing is simply the mirror image of the right one's.
    /// </remarks>
    [CreateAssetMenu(fileName = "Wing Skeleton", menuName = "Alate/Wing Skeleton", order = 310)]
    [MovedFrom(true, null, "Alate")]
    public sealed class WingSkeleton : ScriptableObject
    {
        /// <summary>Version of the format that this package writes.</summary>
        public const int CurrentVersion = 1;

        /// <summary>Fewest chains of a wing (Sec. 4.1).</summary>
        public const int MinChains = 3;

        /// <summary>Fewest joints of a chain (Sec. 4.1).</summary>
        public const int MinJoints = 3;

        /// <summary>Most chains of a wing.</summary>
        public const int MaxChains = 16;

        /// <summary>Most joints of a chain.</summary>
        public const int MaxJoints = 16;

        [SerializeField, HideInInspector] private int m_Version = CurrentVersion;
        [SerializeField] private Vector3 m_Hinge;
        [SerializeField] private Vector3 m_SpanAxis = Vector3.right;
        [SerializeField] private Vector3 m_UpAxis = Vector3.up;
        [SerializeField] private JointChain[] m_Chains = Array.Empty<JointChain>();

        /// <summary>Version of the format in which this skeleton was written.</summary>
        public int Version => m_Version;

        /// <summary>The point about which the wing turns, mesh space. Usually the root of the principal chain.</summary>
        public Vector3 Hinge
        {
            get => m_Hinge;
            set => m_Hinge = value;
        }

        /// <summary>Direction from hinge to tip, mesh space, any length.</summary>
        public Vector3 SpanAxis
        {
            get => m_SpanAxis;
            set => m_SpanAxis = value;
        }

        /// <summary>Direction of the wing's dorsal side, mesh space, any length; its part along the span is ignored.</summary>
        public Vector3 UpAxis
        {
            get => m_UpAxis;
            set => m_UpAxis = value;
        }

        /// <summary>The chains from leading to trailing edge; never null. The arrays are the skeleton's own, not copies.</summary>
        public JointChain[] Chains
        {
            get => m_Chains ?? Array.Empty<JointChain>();
            set => m_Chains = value ?? Array.Empty<JointChain>();
        }

        /// <summary>Number of chains.</summary>
        public int ChainCount => Chains.Length;

        /// <summary>Joints of the first chain, and in a valid skeleton of every chain; 0 without chains.</summary>
        public int JointsPerChain => ChainCount == 0 ? 0 : m_Chains[0].Length;

        /// <summary>True where <see cref="Validate"/> finds no problem.</summary>
        public bool IsValid => Validate().Count == 0;

        /// <summary>Rest position of a joint, mesh space.</summary>
        /// <param name="chain">0 is the leading edge.</param>
        /// <param name="joint">0 is the root.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such chain or joint.</exception>
        public Vector3 GetJoint(int chain, int joint)
        {
            if (chain < 0 || chain >= ChainCount)
                throw new ArgumentOutOfRangeException(nameof(chain), chain, $"The skeleton has {ChainCount} chains.");
            JointChain found = m_Chains[chain];
            if (joint < 0 || joint >= found.Length)
                throw new ArgumentOutOfRangeException(nameof(joint), joint, $"Chain {chain} has {found.Length} joints.");
            return found.joints[joint];
        }

        /// <summary>
        /// Finds every reason why this skeleton cannot be used; empty when it can be used. Never throws, whatever the content: problems of
        /// number hide those of place, which need complete chains.
        /// </summary>
        public List<SkeletonProblem> Validate() => SkeletonValidation.Run(this);
    }
}
