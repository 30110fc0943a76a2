namespace Alate.Cli;

/// <summary>One number of a species at another value.</summary>
internal sealed record ParameterChange(FlownParameter Parameter, float Value)
{
    /// <summary>Changes the kinds of wings of one insect.</summary>
    public void ApplyTo(IReadOnlyList<WingPreset> wings) => Parameter.Set(wings, Value);
}
