using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Where acts tell what they are about to change. All that is recorded between <see cref="Begin"/> and its <see cref="End"/> is undone
    /// in one step. Steps may nest; then the outermost counts.
    /// </summary>
    internal interface IUndoRecorder
    {
        /// <summary>Opens a step. One in which nothing is recorded leaves no trace.</summary>
        void Begin(string act);

        /// <summary>Keeps an object's state, before its first change in this step.</summary>
        void Record(Object target);

        /// <summary>Says that an object has been changed, so that it will be saved.</summary>
        void Changed(Object target);

        /// <summary>Closes the step.</summary>
        void End();

        /// <summary>Closes the outermost step, and takes back all that has been changed in it.</summary>
        void Cancel();
    }
}
