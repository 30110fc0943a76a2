namespace Unity.Collections;

/// <summary>The ledger counts in each mode; with stack traces its description also says where an allocation was made.</summary>
public static class NativeLeakDetection
{
    public static NativeLeakDetectionMode Mode { get; set; } = NativeLeakDetectionMode.Enabled;
}
