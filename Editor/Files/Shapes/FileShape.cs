using System;
using System.Collections.Generic;

namespace Alate.Files
{
    /// <summary>
    /// Description of a value of a file: the reader checks by it, and the schema and the manual's tables are written from it.
    /// </summary>
    internal abstract class FileShape
    {
        /// <summary>The value in words, such as "a number from 0 to 180, degrees".</summary>
        public abstract string Words { get; }

        /// <summary>Kinds of the values inside.</summary>
        public virtual IEnumerable<FileShape> Inner => Array.Empty<FileShape>();

        /// <summary>Checks a value.</summary>
        /// <exception cref="FormatException">It is none of this kind; the message names its place and what is allowed.</exception>
        public abstract void Check(JsonPlace value);

        /// <summary>Error that says what is allowed.</summary>
        protected FormatException Not(JsonPlace value) => value.Wrong($"it must be {Words}, not {value.Shown}");
    }
}
