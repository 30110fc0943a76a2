using System;
using Alate.Authoring;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Traces a picture for the wizard: holds the result, or the reason why there is none.</summary>
    internal sealed class WingImageTracing
    {
        private WingImageTracing(WingTrace trace, string problem)
        {
            Trace = trace;
            Problem = problem;
        }

        /// <summary>Result; null when there is a problem.</summary>
        public WingTrace Trace { get; }

        /// <summary>Problem in one sentence for the user; null when there is none.</summary>
        public string Problem { get; }

        /// <summary>Traces a readable texture.</summary>
        public static WingImageTracing Run(Texture2D picture, in WingTracingSettings settings)
        {
            try
            {
                return new WingImageTracing(WingTracer.Trace(WingPicture.FromTexture(picture), settings), null);
            }
            catch (Exception problem) when (problem is FormatException || problem is ArgumentException)
            {
                return new WingImageTracing(null, FirstLine(problem.Message));
            }
        }

        // What follows names a parameter, which means nothing to a user.
        private static string FirstLine(string message)
        {
            int end = message.IndexOfAny(new[] { '\r', '\n' });
            string line = end < 0 ? message : message.Substring(0, end);
            int parameter = line.IndexOf(" (Parameter '", StringComparison.Ordinal);
            return parameter < 0 ? line : line.Substring(0, parameter);
        }
    }
}
