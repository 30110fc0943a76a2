using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace Alate.Proof
{
    /// <summary>A Unity editor that was started with arguments, until it ends or its time is over.</summary>
    internal sealed class EditorProcess : IDisposable
    {
        private readonly Process m_Process;
        private readonly DateTime m_Deadline;

        /// <param name="editor">Path of the program.</param>
        /// <param name="arguments">Arguments, each as it is.</param>
        /// <param name="most">Time after which it is ended.</param>
        public EditorProcess(string editor, IEnumerable<string> arguments, TimeSpan most)
        {
            var start = new ProcessStartInfo(editor) { UseShellExecute = false };
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            m_Deadline = DateTime.UtcNow + most;
            m_Process = Process.Start(start);
        }

        /// <summary>True after it ended; ends one whose time is over.</summary>
        public bool HasEnded
        {
            get
            {
                if (!m_Process.HasExited && DateTime.UtcNow > m_Deadline)
                    End();
                return m_Process.HasExited;
            }
        }

        /// <summary>Exit code of one that has ended.</summary>
        public int ExitCode => m_Process.ExitCode;

        /// <summary>Ends it at once.</summary>
        public void End()
        {
            if (m_Process.HasExited)
                return;
            m_Process.Kill();
            m_Process.WaitForExit();
        }

        public void Dispose()
        {
            End();
            m_Process.Dispose();
        }
    }
}
