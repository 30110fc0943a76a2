using System.Collections.Generic;

namespace Alate.Fitting
{
    /// <summary>Collects what a fit is unsure about while it goes on.</summary>
    internal sealed class FitNotes
    {
        private readonly List<SkeletonFitWarning> m_Warnings = new List<SkeletonFitWarning>();

        public IReadOnlyList<SkeletonFitWarning> Warnings => m_Warnings;

        /// <summary>The product of all doubts so far.</summary>
        public double Confidence { get; private set; } = 1.0;

        /// <summary>Whether there is a warning of this kind so far.</summary>
        public bool Warned(SkeletonFitWarningKind kind) => m_Warnings.Exists(warning => warning.Kind == kind);

        /// <summary>A doubt and its sentence.</summary>
        public void Warn(SkeletonFitWarningKind kind, double confidence, string message)
        {
            m_Warnings.Add(new SkeletonFitWarning(kind, message));
            LowerConfidence(confidence);
        }

        /// <summary>A doubt that needs no words.</summary>
        public void LowerConfidence(double confidence) => Confidence *= confidence;
    }
}
