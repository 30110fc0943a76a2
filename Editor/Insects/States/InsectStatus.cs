using System.Collections.Generic;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Content of the one help box of the inspector for the selected insects.</summary>
    internal readonly struct InsectStatus
    {
        private InsectStatus(InsectWings insect, in InsectProblem problem, MessageType kind, string message)
        {
            Insect = insect;
            Problem = problem;
            Kind = kind;
            Message = message;
        }

        /// <summary>Insect that the status is about; null when there is nothing to say.</summary>
        public InsectWings Insect { get; }

        /// <summary>Problem of the insect, for which there may be fixes.</summary>
        public InsectProblem Problem { get; }

        /// <summary>Error: wings do not live. Warning: they rest for now. Info: nothing is wrong.</summary>
        public MessageType Kind { get; }

        /// <summary>Text of the box; empty for no box.</summary>
        public string Message { get; }

        /// <summary>True where there is a box to show.</summary>
        public bool IsShown => !string.IsNullOrEmpty(Message);

        /// <summary>Finds the status of all insects: the first problem is shown, others are counted.</summary>
        public static InsectStatus Of(IReadOnlyList<InsectWings> insects)
        {
            var first = default(InsectStatus);
            int others = 0;
            foreach (InsectWings insect in insects)
            {
                if (insect == null)
                    continue;
                InsectStatus status = Of(insect);
                if (!status.IsShown)
                    continue;
                if (first.IsShown && first.Kind >= status.Kind)
                {
                    others += status.Problem.IsProblem ? 1 : 0;
                    continue;
                }

                others += first.Problem.IsProblem ? 1 : 0;
                first = status;
            }

            return others == 0 ? first : first.With($"{first.Message} {Others(others)}");
        }

        /// <summary>Finds the status of one insect.</summary>
        public static InsectStatus Of(InsectWings insect)
        {
            InsectProblem problem = FindProblem(insect);
            if (problem.IsProblem)
            {
                return new InsectStatus(
                    insect, problem, problem.State == InsectState.ZeroScale ? MessageType.Warning : MessageType.Error, problem.Message);
            }
            string rest = Rest(insect) ?? Skinning(insect);
            return rest == null ? default : new InsectStatus(insect, problem, MessageType.Info, rest);
        }

        /// <summary>Problem of an insect, now or once it would live.</summary>
        public static InsectProblem FindProblem(InsectWings insect)
        {
            if (insect.State != InsectState.Inactive)
                return insect.Problem;
            InsectProblem problem = insect.FindProblem();
            int wing = problem.IsProblem ? -1 : StaticBatchingFix.FindFlagged(insect);
            return wing < 0
                ? problem
                : new InsectProblem(InsectState.StaticBatch, wing,
                    $"Wing {wing}: static batching will merge '{insect.Wings[wing].Renderer.name}' with other meshes when play begins. "
                    + "Turn off Batching Static on it.");
        }

        // Why healthy wings do not move.
        private static string Rest(InsectWings insect)
        {
            if (insect.State == InsectState.Waiting)
                return "The wings start in one of the next frames.";
            if (insect.Live == null || insect.Detail != WingDetail.Frozen)
                return null;
            return insect.Live.visible
                ? "The wings have come to rest because the insect is so small on the screen; see Quality."
                : "The wings stand still while no camera sees them, and make up for it when one does; see Quality.";
        }

        private static string Skinning(InsectWings insect) => insect.SkinningObstacle.Length == 0 ? null
            : $"The processor deforms the wings, since {insect.SkinningObstacle}.";

        private static string Others(int count) =>
            count == 1 ? "One more of the selected insects has a problem." : $"{count} more of the selected insects have problems.";

        private InsectStatus With(string message) => new InsectStatus(Insect, Problem, Kind, message);
    }
}
