namespace Alate.Cli;

/// <summary>Every number of one kind of wing, in each of its variants.</summary>
/// <param name="Wing">The kind of wing.</param>
/// <param name="Values">[variant][parameter]</param>
internal sealed record WingNumbers(WingDefinition Wing, IReadOnlyList<IReadOnlyList<float>> Values)
{
    public static IReadOnlyList<FlownParameter> Parameters => FlownParameters.OfSpecies;

    public IReadOnlyList<InsectVariant> Variants => Wing.Variants;

    /// <summary>A number of the standard variant by its name.</summary>
    public float this[string name] => Values[0][Parameters.Select(parameter => parameter.Name).ToList().IndexOf(name)];

    public static WingNumbers Of(WingDefinition wing) => new(wing, wing.Variants.Select(variant => Read(wing, variant)).ToList());

    private static float[] Read(WingDefinition wing, InsectVariant variant)
    {
        WingPreset preset = wing.CreatePreset(variant: variant);
        float[] values = Parameters.Select(parameter => parameter.Of(preset)).ToArray();
        UnityEngine.Object.DestroyImmediate(preset);
        return values;
    }
}
