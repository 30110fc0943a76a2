namespace UnityEditor;

public enum ModelImporterTangents
{
    Import = 0,
    CalculateLegacy = 1,
    None = 2,
    CalculateMikk = 3,
    CalculateLegacyWithSplitTangents = 4,
}
