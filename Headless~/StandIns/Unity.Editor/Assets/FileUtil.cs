namespace UnityEditor;

public class FileUtil
{
    public static string GetPhysicalPath(string path) => StandIns.ProjectFiles.Of(path);
}
