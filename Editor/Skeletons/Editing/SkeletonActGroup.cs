using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Commands that belong together in menus and panels.</summary>
    internal sealed class SkeletonActGroup
    {
        public SkeletonActGroup(string name, params EditCommand[] acts)
        {
            Name = name;
            Acts = acts;
        }

        public string Name { get; }

        public IReadOnlyList<EditCommand> Acts { get; }
    }
}
