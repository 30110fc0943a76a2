using System;

namespace Alate
{
    /// <summary>Meanings of a word in the name of an object, for finding wings.</summary>
    [Flags]
    internal enum WingWord
    {
        /// <summary>Word without a meaning for wings, such as "mesh".</summary>
        Plain = 0,

        Wing = 1,
        Left = 2,
        Right = 4,
        Fore = 8,
        Hind = 16,

        /// <summary>Word for another part of an animal.</summary>
        Body = 32,

        /// <summary>Word for the mount of a wing, or for its stand-in in physics.</summary>
        Mount = 64,

        /// <summary>Word for a hard cover of a wing, which does not flex, or for a haltere.</summary>
        Case = 128,
    }
}
