namespace Unity.Burst;

public enum OptimizeFor
{
    Default = 0,
    Performance = 1,
    Size = 2,
    FastCompilation = 3,
    Balanced = 4,
}
