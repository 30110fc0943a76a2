using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Records changes for undo. All changes between <see cref="Begin"/> and its <see cref="End"/> are undone in one step. Steps may nest;
    /// then the outermost counts.
    /// </summary>
    internal interface IUndoRecorder
    {
        /// <summary>Opens a step. One in which nothing is recorded leaves no trace.</summary>
        void Begin(string undoName);

        /// <summary>Records an object's state, before its first change in this step.</summary>
        void Record(Object target);

        /// <summary>Marks an object as changed, so that it will be saved.</summary>
        void Changed(Object target);

        /// <summary>Closes the step.</summary>
        void End();

        /// <summary>Closes the outermost step, and reverts all its changes.</summary>
        void Cancel();
    }
}
