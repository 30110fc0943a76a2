using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Kinds of problems of a <see cref="WingSkeleton"/>.</summary>
    [MovedFrom(true, null, "Alate")]
    public enum SkeletonProblemKind
    {
        /// <summary>The skeleton was written by a newer version of the package.</summary>
        UnsupportedVersion,

        /// <summary>The skeleton has fewer than <see cref="WingSkeleton.MinChains"/> chains.</summary>
        TooFewChains,

        /// <summary>The skeleton has more than <see cref="WingSkeleton.MaxChains"/> chains.</summary>
        TooManyChains,

        /// <summary>A chain has fewer than <see cref="WingSkeleton.MinJoints"/> joints.</summary>
        TooFewJoints,

        /// <summary>A chain has more than <see cref="WingSkeleton.MaxJoints"/> joints.</summary>
        TooManyJoints,

        /// <summary>A chain has not as many joints as the first chain.</summary>
        UnequalJointCounts,

        /// <summary>The hinge or a joint is infinite or not a number.</summary>
        NonFinitePosition,

        /// <summary>Span and up axis are zero, not finite or parallel, or do not suit the joints.</summary>
        InvalidAxes,

        /// <summary>Two joints share one place. Only the roots of different chains may.</summary>
        CoincidentJoints,

        /// <summary>Bones of two chains meet, seen from above the wing.</summary>
        CrossingChains,

        /// <summary>Chain 0 is not the one on the leading edge.</summary>
        PrincipalChainNotLeading,

        /// <summary>The chains do not follow one another from the leading to the trailing edge.</summary>
        ChainsOutOfOrder,

        /// <summary>A measured stiffness or the width of a vein is not a number, out of its range, or one of too many.</summary>
        InvalidStiffness,
    }
}
