using System;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Command of the tool on a skeleton, as offered by menus, buttons and keys.</summary>
    internal sealed class EditCommand
    {
        private readonly Func<SkeletonEditing, EditOutcome> m_Run;

        /// <param name="name">What menus and undo call it.</param>
        /// <param name="key">Its key, or <see cref="KeyCode.None"/>.</param>
        /// <param name="shift">Whether the key is pressed with Shift.</param>
        /// <param name="tooltip">One sentence.</param>
        /// <param name="run">Does it, checked and recorded for undo.</param>
        public EditCommand(string name, KeyCode key, bool shift, string tooltip, Func<SkeletonEditing, EditOutcome> run)
        {
            Name = name;
            Key = key;
            Shift = shift;
            Tooltip = tooltip;
            m_Run = run;
        }

        public string Name { get; }

        public KeyCode Key { get; }

        public bool Shift { get; }

        public string Tooltip { get; }

        /// <summary>Key of the command: "Shift+C"; empty where there is none.</summary>
        public string Shortcut => Key == KeyCode.None ? "" : Shift ? "Shift+" + Key : Key.ToString();

        /// <summary>Name of the command with its key, for menus.</summary>
        public string Title => Key == KeyCode.None ? Name : $"{Name} ({Shortcut})";

        /// <summary>Runs the command on one skeleton.</summary>
        public EditOutcome Run(SkeletonEditing editing) => m_Run(editing);

        public override string ToString() => Name;
    }
}
