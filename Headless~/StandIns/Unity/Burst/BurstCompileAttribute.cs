using System;

namespace Unity.Burst;

/// <summary>Has no effect here: RyuJIT compiles everything.</summary>
[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Method)]
public class BurstCompileAttribute : Attribute
{
    public BurstCompileAttribute()
    {
    }

    public BurstCompileAttribute(FloatPrecision floatPrecision, FloatMode floatMode)
    {
        FloatPrecision = floatPrecision;
        FloatMode = floatMode;
    }

    public FloatMode FloatMode { get; set; }

    public FloatPrecision FloatPrecision { get; set; }

    public bool CompileSynchronously { get; set; }

    public bool DisableSafetyChecks { get; set; }

    public OptimizeFor OptimizeFor { get; set; }
}
