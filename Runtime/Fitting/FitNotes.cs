using System.Collections.Generic;
using System.Globalization;

namespace Alate.Fitting
{
    /// <summary>Collects the warnings of a fit and the confidence that they leave.</summary>
    internal sealed class FitNotes
    {
        private readonly List<SkeletonFitWarning> m_Warnings = new List<SkeletonFitWarning>();

        public IReadOnlyList<SkeletonFitWarning> Warnings => m_Warnings;

        /// <summary>Product of the confidences of all doubts so far, 0 to 1.</summary>
        public double Confidence { get; private set; } = 1.0;

        /// <summary>Returns true where there is a warning of this kind so far.</summary>
        public bool Warned(SkeletonFitWarningKind kind) => m_Warnings.Exists(warning => warning.Kind == kind);

        /// <summary>Adds a warning with its sentence, and lowers the confidence by its factor.</summary>
        public void Warn(SkeletonFitWarningKind kind, double confidence, string message)
        {
            m_Warnings.Add(new SkeletonFitWarning(kind, message));
            LowerConfidence(confidence);
        }

        /// <summary>A share in a sentence, in per cent.</summary>
        public static string Percent(double share, string format = "F0") =>
            (100.0 * share).ToString(format, CultureInfo.InvariantCulture) + " %";

        /// <summary>Lowers the confidence by a factor without a warning.</summary>
        public void LowerConfidence(double confidence) => Confidence *= confidence;
    }
}
