namespace Unity.Burst;

public static class BurstCompiler
{
    /// <summary>False: there is no Burst compiler here.</summary>
    public static bool IsEnabled => false;
}
