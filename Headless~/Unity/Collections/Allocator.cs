namespace Unity.Collections;

/// <summary>How long an allocation may live.</summary>
public enum Allocator
{
    Invalid = 0,
    None = 1,
    Temp = 2,
    TempJob = 3,
    Persistent = 4,
}
