namespace UnityEditor;

[System.Flags]
public enum StaticEditorFlags
{
    ContributeGI = 1,
    OccluderStatic = 2,
    BatchingStatic = 4,
    OccludeeStatic = 16,
    ReflectionProbeStatic = 64,
}
