namespace Alate.Cli;

/// <summary>Tables of the report; the first alone is counted.</summary>
internal enum ValidationTable
{
    /// <summary>Insects beside measured and published flights.</summary>
    Insects,

    /// <summary>Wakes beside closed forms and measured wings.</summary>
    Wakes,

    /// <summary>Strips beside beam theory.</summary>
    Strips,

    /// <summary>Curves of the user.</summary>
    Data,
}
