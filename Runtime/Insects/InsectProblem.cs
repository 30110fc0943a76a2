using System;

namespace Alate
{
    /// <summary>Reason why an insect's wings do not live, with the remedy.</summary>
    public readonly struct InsectProblem
    {
        private readonly string m_Message;

        internal InsectProblem(InsectState state, int wing, string message)
        {
            State = state;
            Wing = wing;
            m_Message = message;
        }

        /// <summary>The kind of problem; <see cref="InsectState.Ready"/> for none.</summary>
        public InsectState State { get; }

        /// <summary>Index of the wing in the list, or −1 when the problem is not about one wing.</summary>
        public int Wing { get; }

        /// <summary>Message of one sentence that names the object and one that names the remedy; empty for no problem.</summary>
        public string Message => m_Message ?? "";

        /// <summary>True where the user has something to mend.</summary>
        public bool IsProblem => State > InsectState.Ready;

        /// <summary>State of an insect that is not in play, or is switched off.</summary>
        internal static InsectProblem Inactive => new InsectProblem(InsectState.Inactive, -1, "");

        /// <summary>State of an insect in the queue.</summary>
        internal static InsectProblem Waiting => new InsectProblem(InsectState.Waiting, -1, "");

        /// <summary>Problem of a scale of zero.</summary>
        internal static InsectProblem NoSize => new InsectProblem(InsectState.ZeroScale, -1,
            "a wing has a scale of zero. Give it, and all that it hangs on, some other scale; its wings feel nothing until then.");

        /// <summary>Problem of an unexpected exception.</summary>
        internal static InsectProblem Failed(Exception exception) => new InsectProblem(InsectState.Failed, -1,
            $"an error came up while its wings were built ({exception.GetType().Name}, in the console). Please report it; disable and "
            + "enable the component to try again.");

        /// <summary>No problem.</summary>
        internal static InsectProblem None => new InsectProblem(InsectState.Ready, -1, "");

        /// <summary>Message that names the insect.</summary>
        internal InsectProblem Of(string insect)
        {
            string where = Wing < 0 ? $"'{insect}'" : $"'{insect}', wing {Wing}";
            return new InsectProblem(State, Wing, $"{where}: {Message}");
        }
    }
}
