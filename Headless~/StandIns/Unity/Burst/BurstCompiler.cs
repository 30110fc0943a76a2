namespace Unity.Burst;

public static class BurstCompiler
{
    public static readonly BurstCompilerOptions Options = new();

    /// <summary>False: there is no Burst compiler here.</summary>
    public static bool IsEnabled => false;
}
