namespace Alate.Cli;

/// <summary>Error that the user can mend: its message is the one line that they see.</summary>
public sealed class UserException(string message) : Exception(message);
