using UnityEngine.Scripting.APIUpdating;

namespace Alate.Fitting
{
    /// <summary>Doubt about a <see cref="SkeletonFit"/>.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public readonly struct SkeletonFitWarning
    {
        /// <summary>A warning with its sentence.</summary>
        public SkeletonFitWarning(SkeletonFitWarningKind kind, string message)
        {
            Kind = kind;
            Message = message;
        }

        /// <summary>Kind of the warning.</summary>
        public SkeletonFitWarningKind Kind { get; }

        /// <summary>One sentence for the user, with the number or the object in question.</summary>
        public string Message { get; }

        /// <summary>Returns the message.</summary>
        public override string ToString() => Message;
    }
}
