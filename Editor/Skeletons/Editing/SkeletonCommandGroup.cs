using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Commands that belong together in menus and panels.</summary>
    internal sealed class SkeletonCommandGroup
    {
        public SkeletonCommandGroup(string name, params EditCommand[] commands)
        {
            Name = name;
            Commands = commands;
        }

        public string Name { get; }

        public IReadOnlyList<EditCommand> Commands { get; }
    }
}
