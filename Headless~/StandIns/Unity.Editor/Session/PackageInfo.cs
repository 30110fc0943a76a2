using System.Reflection;

namespace UnityEditor.PackageManager;

public sealed class PackageInfo
{
    internal PackageInfo()
    {
    }

    public string version { get; internal init; }

    public string resolvedPath { get; internal init; }

    /// <summary>The package that a test has installed; null otherwise, as in Unity for an assembly that comes in no package.</summary>
    public static PackageInfo FindForAssembly(Assembly assembly) => StandIns.InstalledPackage.Folder == null ? null
        : new PackageInfo { resolvedPath = StandIns.InstalledPackage.Folder, version = StandIns.InstalledPackage.Version };
}
