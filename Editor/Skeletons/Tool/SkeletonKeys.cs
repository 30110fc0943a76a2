using System;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Maps keys and the commands of the Edit menu to a session.</summary>
    internal static class SkeletonKeys
    {
        /// <summary>Command that the scene view's own frame key sends.</summary>
        public const string FrameSelected = "FrameSelected";

        /// <summary>Key that shows or hides the wing's shape in its beat.</summary>
        public const KeyCode Beat = KeyCode.K;

        /// <summary>Key that, with Shift, switches symmetric editing.</summary>
        public const KeyCode Symmetry = KeyCode.M;

        private const string k_SelectAll = "SelectAll";
        private const string k_DeselectAll = "DeselectAll";
        private const string k_InvertSelection = "InvertSelection";
        private const string k_Delete = "Delete";
        private const string k_SoftDelete = "SoftDelete";

        private static readonly string[] s_Commands =
        {
            FrameSelected, k_SelectAll, k_DeselectAll, k_InvertSelection, k_Delete, k_SoftDelete,
        };

        /// <summary>Returns true where a command of the editor has a meaning here.</summary>
        public static bool Knows(string command) => Array.IndexOf(s_Commands, command) >= 0;

        /// <summary>Runs a command, except framing, which is the window's. Does nothing while the mouse is down.</summary>
        public static void Execute(SkeletonSession session, string command)
        {
            if (session.Pointer.IsDown)
                return;
            switch (command)
            {
                case k_SelectAll:
                    session.Group.SelectAll();
                    break;
                case k_DeselectAll:
                    session.Group.Select(null, Array.Empty<JointIndex>(), adds: false);
                    break;
                case k_InvertSelection:
                    session.Do(SkeletonCommands.Find("Invert Selection"));
                    break;
                case k_Delete:
                case k_SoftDelete:
                    session.Do(SkeletonCommands.Delete);
                    break;
            }
        }

        /// <summary>Runs the command of a key.</summary>
        /// <returns>Whether it means anything.</returns>
        public static bool Press(SkeletonSession session, KeyCode key, EventModifiers modifiers)
        {
            const EventModifiers others = EventModifiers.Control | EventModifiers.Command | EventModifiers.Alt;
            if ((modifiers & others) != 0)
                return false;
            bool shift = (modifiers & EventModifiers.Shift) != 0;
            if (key == KeyCode.Escape)
                return Escape(session);
            if (key == Beat && !shift)
            {
                session.Overlay.ShowsBeat = !session.Overlay.ShowsBeat;
                return true;
            }

            if (key == Symmetry && shift)
            {
                session.IsSymmetric = !session.IsSymmetric;
                return true;
            }

            EditCommand command = SkeletonCommands.Find(key, shift);
            if (command != null && !session.Pointer.IsDown)
                session.Do(command);
            return command != null;
        }

        // First what the mouse is doing, then the selection; with neither, the editor's own meaning of the key.
        private static bool Escape(SkeletonSession session)
        {
            if (session.Pointer.IsDown)
            {
                session.Pointer.Cancel();
                return true;
            }

            bool any = session.Group.SelectedCount > 0;
            if (any)
                session.Group.Select(null, Array.Empty<JointIndex>(), adds: false);
            return any;
        }
    }
}
