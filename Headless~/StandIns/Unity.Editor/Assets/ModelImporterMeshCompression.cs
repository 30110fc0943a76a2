namespace UnityEditor;

public enum ModelImporterMeshCompression
{
    Off = 0,
    Low = 1,
    Medium = 2,
    High = 3,
}
