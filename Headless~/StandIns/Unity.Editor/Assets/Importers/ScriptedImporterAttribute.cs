using System;

namespace UnityEditor.AssetImporters;

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public class ScriptedImporterAttribute : Attribute
{
    public ScriptedImporterAttribute(int version, string ext, int importQueueOffset)
    {
        this.version = version;
        fileExtensions = [ext];
        importQueuePriority = importQueueOffset;
    }

    public int version { get; }
    public int importQueuePriority { get; }
    public string[] fileExtensions { get; }
}
