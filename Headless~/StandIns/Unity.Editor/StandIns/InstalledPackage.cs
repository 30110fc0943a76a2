namespace StandIns;

/// <summary>Package in which all assemblies of this process lie, where a test says so.</summary>
[Unity.StandIns.StandInExtension]
public static class InstalledPackage
{
    /// <summary>Its folder; null where there is none.</summary>
    public static string Folder { get; set; }

    /// <summary>Its version.</summary>
    public static string Version { get; set; } = "";
}
