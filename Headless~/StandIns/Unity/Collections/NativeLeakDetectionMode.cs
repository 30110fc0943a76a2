namespace Unity.Collections;

/// <summary>Detail in which the ledger of native memory records each allocation.</summary>
public enum NativeLeakDetectionMode
{
    Disabled = 1,
    Enabled = 2,
    EnabledWithStackTrace = 3,
}
