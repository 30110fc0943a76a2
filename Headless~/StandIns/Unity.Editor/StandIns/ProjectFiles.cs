using System.IO;

namespace StandIns;

/// <summary>Folder on the disk with the files of the project's assets, one for this run.</summary>
internal static class ProjectFiles
{
    private static string s_Folder;

    /// <summary>The file of an asset, whether it is there or not; its folder is.</summary>
    public static string Of(string path)
    {
        s_Folder ??= Directory.CreateTempSubdirectory("alate-project-").FullName;
        string file = Path.Combine(s_Folder, path);
        Directory.CreateDirectory(Path.GetDirectoryName(file));
        return file;
    }

    /// <summary>Deletes all.</summary>
    public static void Clear()
    {
        if (s_Folder != null)
            Directory.Delete(s_Folder, true);
        s_Folder = null;
    }
}
