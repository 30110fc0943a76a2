using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Table of every command of the tool, for the panel, the context menu, the keys and the manual. The keys are letters to which the
    /// scene view gives no meaning of its own.
    /// </summary>
    internal static class SkeletonCommands
    {
        /// <summary>Commands in menu order, in groups.</summary>
        public static readonly IReadOnlyList<SkeletonCommandGroup> Groups = new[]
        {
            new SkeletonCommandGroup(
                "Select",
                Make("Select Chain", KeyCode.D, false, "Selects the whole chains of the selected joints.",
                    editing => Select(editing, SelectCommands.Chains)),
                Make("Select Row", KeyCode.D, true, "Selects the same joint of every chain.",
                    editing => Select(editing, SelectCommands.Rows)),
                Make("Invert Selection", KeyCode.I, true, "Selects the joints that are not selected.",
                    editing => Select(editing, SelectCommands.Others))),
            new SkeletonCommandGroup(
                "Chains and joints",
                Make("Add Chain Behind", KeyCode.C, false,
                    "Adds a chain behind that of the selected joint, halfway to the next; behind the last one, beyond it.",
                    ChainCommands.AddBehind),
                Make("Add Chain Before", KeyCode.B, false,
                    "Adds a chain before that of the selected joint; before the first one it becomes the principal chain.",
                    ChainCommands.AddBefore),
                Make("Remove Chain", KeyCode.C, true, "Removes the chains of the selected joints.", ChainCommands.Remove),
                Make("Add Joint Row", KeyCode.J, false, "Adds a joint to every chain, beyond the selected one.", RowCommands.Add),
                Make("Remove Joint Row", KeyCode.J, true, "Removes the selected joint from every chain.", RowCommands.Remove),
                Make("Reverse Chains", KeyCode.None, false,
                    "Turns the order of the chains round, where the first is not on the leading edge.", ChainCommands.Reverse)),
            new SkeletonCommandGroup(
                "Shape",
                Make("Space Evenly", KeyCode.N, false, "Spaces joints evenly along the chains of the selected joints, or all chains.",
                    ResampleCommands.Evenly),
                Make("Straighten", KeyCode.S, false,
                    "Puts the chains of the selected joints on straight lines; with three or more joints selected in a chain, the "
                    + "run between them.",
                    LineCommands.Straighten),
                Make("Smooth", KeyCode.S, true,
                    "Moves the selected joints, or all, halfway to the middle of those around them. Roots and tips stay.",
                    LineCommands.Smooth),
                Make("Snap To Surface", KeyCode.P, false, "Moves the selected joints to the closest points of the mesh.", Snap)),
            new SkeletonCommandGroup(
                "Hinge and axes",
                Make("Set Hinge", KeyCode.O, false, "Puts the hinge at the selected joint; at the first root where none is selected.",
                    FrameCommands.SetHinge),
                Make("Set Span Axis", KeyCode.U, true,
                    "Turns the span axis from the hinge to the selected joint, or to the tip of the principal chain.",
                    FrameCommands.SetSpan),
                Make("Fit Axes", KeyCode.U, false, "Fits the span and up axis to the joints.",
                    (draft, selected) => FrameCommands.FitAxes(draft)),
                Make("Flip Up Axis", KeyCode.None, false, "Makes the upper side the lower one.",
                    (draft, selected) => FrameCommands.FlipUp(draft))),
            new SkeletonCommandGroup(
                "Whole skeleton",
                Make("Mirror Onto Other Side", KeyCode.M, false, "Makes the other wing's skeleton the mirror image of this one.",
                    editing => editing.MirrorOntoTwin()),
                Make("Lay Out Again", KeyCode.None, false,
                    "Makes hinge, axes and chains from the mesh alone, in place of those there are.", LayOut),
                Make("Mend", KeyCode.None, false,
                    "Makes complete chains of finite joints where counts differ or numbers are broken.", Mend)),
        };

        /// <summary>All commands in menu order.</summary>
        public static readonly IReadOnlyList<EditCommand> All = Flatten();

        /// <summary>Command of the Delete key: removes chains where whole chains are selected, else rows.</summary>
        public static readonly EditCommand Delete = new EditCommand(
            "Delete Joints", KeyCode.None, false, "Removes the selected chains, or rows.", editing => ForDelete(editing).Run(editing));

        /// <summary>Finds a command by name.</summary>
        /// <exception cref="ArgumentException">There is none.</exception>
        public static EditCommand Find(string name)
        {
            foreach (EditCommand command in All)
            {
                if (command.Name == name)
                    return command;
            }

            throw new ArgumentException($"There is no command '{name}'.", nameof(name));
        }

        /// <summary>Finds the command of a key; null where it has none.</summary>
        public static EditCommand Find(KeyCode key, bool shift)
        {
            foreach (EditCommand command in All)
            {
                if (key != KeyCode.None && command.Key == key && command.Shift == shift)
                    return command;
            }

            return null;
        }

        /// <summary>Command of the Delete key for one skeleton.</summary>
        public static EditCommand ForDelete(SkeletonEditing editing)
        {
            JointIndex[] selected = editing.Selection.Living();
            bool whole = SelectCommands.Chains(editing.Skeleton, selected).Count == selected.Length;
            return Find(whole ? "Remove Chain" : "Remove Joint Row");
        }

        private static EditCommand Make(
            string name, KeyCode key, bool shift, string tooltip, Func<SkeletonDraft, JointIndex[], Proposal> make) =>
            new EditCommand(name, key, shift, tooltip, editing => editing.Do(name, make));

        private static EditCommand Make(string name, KeyCode key, bool shift, string tooltip, Func<SkeletonEditing, EditOutcome> run) =>
            new EditCommand(name, key, shift, tooltip, run);

        private static EditOutcome Select(
            SkeletonEditing editing, Func<WingSkeleton, IReadOnlyList<JointIndex>, List<JointIndex>> choose)
        {
            editing.Select(choose(editing.Skeleton, editing.Selection.Living()));
            return EditOutcome.Success;
        }

        private static EditOutcome Snap(SkeletonEditing editing) => editing.Do(
            "Snap To Surface", (draft, selected) => MoveCommands.OnSurface(draft, selected, Vector3.zero, editing.Surface));

        private static IReadOnlyList<EditCommand> Flatten()
        {
            var all = new List<EditCommand>();
            foreach (SkeletonCommandGroup group in Groups)
                all.AddRange(group.Commands);
            return all;
        }

        private static EditOutcome LayOut(SkeletonEditing editing)
        {
            editing.Start(out EditStart start);
            return editing.Commit("Lay Out Again", start, LayOutCommand.Make(editing.Skeleton, editing.Surface, editing.Known));
        }

        private static EditOutcome Mend(SkeletonEditing editing)
        {
            editing.Start(out EditStart start);
            return editing.Commit("Mend", start, MendCommand.Make(editing.Skeleton));
        }
    }
}
