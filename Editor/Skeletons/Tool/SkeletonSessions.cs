using System;
using System.Collections.Generic;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Session that the scene view shows now: the tool's or an inspector's. There is one at a time.</summary>
    internal static class SkeletonSessions
    {
        /// <summary>The session; null where no skeleton is edited.</summary>
        public static SkeletonSession Current { get; private set; }

        /// <summary>Raised when another session is shown, or none.</summary>
        public static event Action Changed;

        /// <summary>Begins a session; the one before it ends.</summary>
        public static SkeletonSession Open(IEnumerable<SkeletonTarget> targets)
        {
            Close(Current);
            var listed = new List<SkeletonTarget>(targets);
            foreach (SkeletonTarget target in listed)
                target.FindLock = LockOf;
            Current = new SkeletonSession(listed, new EditorUndo());
            SkeletonSettings.Restore(Current);
            Undo.undoRedoPerformed += OnUndo;
            Changed?.Invoke();
            SceneView.RepaintAll();
            return Current;
        }

        /// <summary>Ends a session if it is the one that is shown.</summary>
        public static void Close(SkeletonSession session)
        {
            if (session == null || session != Current)
                return;
            Undo.undoRedoPerformed -= OnUndo;
            Current = null;
            SkeletonSettings.Keep(session);
            session.Dispose();
            Changed?.Invoke();
            SceneView.RepaintAll();
        }

        // What is dragged has just been put back: the rest of the drag would not be recorded.
        private static void OnUndo()
        {
            Current.Pointer.LetGo();
            SceneView.RepaintAll();
        }

        /// <summary>
        /// Reason why a skeleton may not be changed; null where it may. Packages from git are overwritten at will, and edits in them are
        /// lost.
        /// </summary>
        public static string LockOf(WingSkeleton skeleton) =>
            AssetLock.IsLocked(skeleton)
                ? $"'{skeleton.name}' is read-only: check it out, or where it is of a package or an imported file, copy it into your "
                    + "project's Assets first."
                : null;
    }
}
