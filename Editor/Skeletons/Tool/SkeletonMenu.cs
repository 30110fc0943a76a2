using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Menu of a right click on a joint.</summary>
    internal static class SkeletonMenu
    {
        public static void Show(SkeletonSession session)
        {
            var menu = new GenericMenu();
            foreach (SkeletonCommandGroup group in SkeletonCommands.Groups)
            {
                if (group != SkeletonCommands.Groups[0])
                    menu.AddSeparator("");
                foreach (EditCommand command in group.Commands)
                    menu.AddItem(new GUIContent(command.Title), false, () => session.Do(command));
            }

            menu.ShowAsContext();
        }
    }
}
