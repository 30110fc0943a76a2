namespace Unity.Burst;

public enum FloatMode
{
    Default = 0,
    Strict = 1,
    Deterministic = 2,
    Fast = 3,
}
