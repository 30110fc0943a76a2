namespace Unity.Collections;

/// <summary>What the ledger of native memory keeps of each allocation.</summary>
public enum NativeLeakDetectionMode
{
    Disabled = 1,
    Enabled = 2,
    EnabledWithStackTrace = 3,
}
