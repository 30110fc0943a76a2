using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Reason why a <see cref="WingSkeleton"/> cannot be used, and its place.</summary>
    [MovedFrom(true, null, "Alate")]
    public readonly struct SkeletonProblem
    {
        /// <summary>Value of <see cref="Chain"/> or <see cref="Joint"/> when the problem concerns none in particular.</summary>
        public const int None = -1;

        /// <summary>A problem with its place.</summary>
        public SkeletonProblem(SkeletonProblemKind kind, int chain, int joint, string message)
        {
            Kind = kind;
            Chain = chain;
            Joint = joint;
            Message = message;
        }

        /// <summary>Kind of the problem.</summary>
        public SkeletonProblemKind Kind { get; }

        /// <summary>Chain that the problem concerns, 0 being the leading edge, or <see cref="None"/>.</summary>
        public int Chain { get; }

        /// <summary>Joint of that chain that the problem concerns, 0 being the root, or <see cref="None"/>.</summary>
        public int Joint { get; }

        /// <summary>One sentence for the user.</summary>
        public string Message { get; }

        /// <summary>Returns the message.</summary>
        public override string ToString() => Message;
    }
}
