using System;

namespace Alate.Files
{
    /// <summary>Error that the user can mend: its message is the one line that they see.</summary>
    public sealed class UserException : Exception
    {
        /// <param name="message">One line that names the thing, its value and what is allowed.</param>
        public UserException(string message)
            : base(message)
        {
        }
    }
}
