using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>One reason why a <see cref="WingSkeleton"/> cannot be used, and where it lies.</summary>
    [MovedFrom(true, null, "Alate")]
    public readonly struct SkeletonProblem
    {
        /// <summary>Stands in <see cref="Chain"/> or <see cref="Joint"/> when the problem concerns none in particular.</summary>
        public const int None = -1;

        /// <summary>A problem with its place.</summary>
        public SkeletonProblem(SkeletonProblemKind kind, int chain, int joint, string message)
        {
            Kind = kind;
            Chain = chain;
            Joint = joint;
            Message = message;
        }

        /// <summary>What is wrong.</summary>
        public SkeletonProblemKind Kind { get; }

        /// <summary>The chain it concerns, 0 being the leading edge, or <see cref="None"/>.</summary>
        public int Chain { get; }

        /// <summary>The joint of that chain it concerns, 0 being the root, or <see cref="None"/>.</summary>
        public int Joint { get; }

        /// <summary>One sentence for the user.</summary>
        public string Message { get; }

        /// <summary>The message.</summary>
        public override string ToString() => Message;
    }
}
