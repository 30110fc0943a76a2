using UnityEngine.Scripting.APIUpdating;

namespace Alate.Fitting
{
    /// <summary>Kinds of doubts about a <see cref="SkeletonFit"/>.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public enum SkeletonFitWarningKind
    {
        /// <summary>No hint about the body was given; the hinge is guessed.</summary>
        HingeGuessed,

        /// <summary>The given hinge lies far off the wing; it served only to find the base.</summary>
        HingeOffWing,

        /// <summary>The forward direction does not tell the edges apart, or there is none; the leading edge is guessed.</summary>
        LeadingEdgeGuessed,

        /// <summary>The up direction does not tell the sides apart; the upper side is guessed.</summary>
        UpperSideGuessed,

        /// <summary>No single place stands out as the wing's tip.</summary>
        TipUnclear,

        /// <summary>The wing has holes; chains run as if they were filled.</summary>
        Holes,

        /// <summary>The mesh has separate pieces on or under the wing, which were ignored.</summary>
        PiecesIgnored,

        /// <summary>The mesh is a closed shell; its upper side stands for the wing.</summary>
        ClosedShell,

        /// <summary>The wing is far from flat; seen from above it appears smaller than it is.</summary>
        StronglyCurved,

        /// <summary>Seen from above, the wing's outline crosses itself.</summary>
        FoldsOverItself,

        /// <summary>Part of a chain lies outside the wing.</summary>
        ChainLeavesWing,

        /// <summary>Chains that follow the wing would cross or break another rule; they are straight rays from the base instead.</summary>
        ChainsLaidAsRays,
    }
}
