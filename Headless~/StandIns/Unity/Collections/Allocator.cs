namespace Unity.Collections;

/// <summary>Lifetime of an allocation.</summary>
public enum Allocator
{
    Invalid = 0,
    None = 1,
    Temp = 2,
    TempJob = 3,
    Persistent = 4,
}
