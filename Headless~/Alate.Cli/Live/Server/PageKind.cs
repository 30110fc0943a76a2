namespace Alate.Cli;

/// <summary>Kinds of pages that browsers show.</summary>
internal enum PageKind
{
    /// <summary>An insect with its simulation behind it.</summary>
    Live,

    /// <summary>Baked insects in a folder.</summary>
    Baked,

    /// <summary>A sample scene that plays.</summary>
    Scene,
}
