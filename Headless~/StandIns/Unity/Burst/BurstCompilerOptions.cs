namespace Unity.Burst;

/// <summary>Options that are kept, and change nothing.</summary>
public sealed class BurstCompilerOptions
{
    internal BurstCompilerOptions()
    {
    }

    public bool EnableBurstCompileSynchronously { get; set; }

    public bool EnableBurstSafetyChecks { get; set; } = true;
}
