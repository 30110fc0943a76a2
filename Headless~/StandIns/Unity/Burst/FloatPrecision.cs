namespace Unity.Burst;

public enum FloatPrecision
{
    Standard = 0,
    High = 1,
    Medium = 2,
    Low = 3,
}
