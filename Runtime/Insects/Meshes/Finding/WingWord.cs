using System;

namespace Alate
{
    /// <summary>What a word in the name of an object can mean for a wing.</summary>
    [Flags]
    internal enum WingWord
    {
        /// <summary>Nothing, such as "mesh".</summary>
        Plain = 0,

        Wing = 1,
        Left = 2,
        Right = 4,
        Fore = 8,
        Hind = 16,

        /// <summary>Other parts of an animal.</summary>
        Body = 32,

        /// <summary>What wings hang from, or what stands for one in physics.</summary>
        Mount = 64,

        /// <summary>Hard covers of wings, which do not flex, and halteres.</summary>
        Case = 128,
    }
}
