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
            foreach (SkeletonActGroup group in SkeletonCommands.Groups)
            {
                if (group != SkeletonCommands.Groups[0])
                    menu.AddSeparator("");
                foreach (EditCommand act in group.Acts)
                    menu.AddItem(new GUIContent(act.Title), false, () => session.Do(act));
            }

            menu.ShowAsContext();
        }
    }
}
