using System;

namespace Alate.Crowds
{
    /// <summary>
    /// An insect cannot be baked as asked; the message is one line that says what is in the way, its value, and what is allowed.
    /// </summary>
    public sealed class BakeException : Exception
    {
        /// <param name="message">One line.</param>
        public BakeException(string message) : base(message)
        {
        }
    }
}
