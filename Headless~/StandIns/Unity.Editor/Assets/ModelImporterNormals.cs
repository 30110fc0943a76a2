namespace UnityEditor;

public enum ModelImporterNormals
{
    Import = 0,
    Calculate = 1,
    None = 2,
}
