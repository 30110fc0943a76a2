namespace Alate.Cli;

/// <summary>Checks of a plan's numbers that the model takes as a product with the species' own.</summary>
internal static class PlanRange
{
    private static readonly WingParameterRange s_Elasticity = Range("elasticity"), s_Density = Range("airDensity"),
        s_Reference = Range("referenceFrequency");

    /// <summary>Refuses a factor on the elasticity that makes too much or too little of the species'.</summary>
    /// <param name="plan">The flight.</param>
    /// <param name="factor">What was typed behind <c>--elasticity</c>.</param>
    /// <exception cref="UserException">It does; the message has the range of the option for the species.</exception>
    public static void CheckElasticity(FlightPlan plan, double factor)
    {
        string subject = KnownSpecies.Titled(plan.Species, plan.Variant);
        FlightNumber number = FlightNumbers.Elasticity;
        TypedRange.Check(
            number.Option, factor, number.Min, number.Max, subject, number.Default, value => Holds(number.In(plan, value)));
    }

    /// <summary>Refuses a value of a parameter that takes the insect out of the model's range.</summary>
    /// <param name="plan">The flight.</param>
    /// <param name="parameter">The number that is changed.</param>
    /// <param name="name">The argument's name.</param>
    /// <param name="value">What was typed.</param>
    /// <exception cref="UserException">It does; the message has the range of the argument for the species.</exception>
    public static void Check(FlightPlan plan, FlownParameter parameter, string name, double value)
    {
        TypedRange.Check(
            name, value, parameter.Min, parameter.Max, $"{parameter.Name} of {plan.Species}", Own(plan, parameter),
            typed => Holds(parameter.In(plan, typed)));
    }

    private static double Own(FlightPlan plan, FlownParameter parameter)
    {
        if (parameter.Of == null)
            return 1;
        List<WingPreset> wings = Wings(plan);
        double own = parameter.Of(wings[0]);
        wings.ForEach(UnityEngine.Object.DestroyImmediate);
        return own;
    }

    private static bool Holds(FlightPlan plan)
    {
        List<WingPreset> wings = Wings(plan);
        plan.Change?.ApplyTo(wings);
        bool holds = wings.TrueForAll(wing => Holds(wing, plan));
        wings.ForEach(UnityEngine.Object.DestroyImmediate);
        return holds;
    }

    private static bool Holds(WingPreset wing, FlightPlan plan)
    {
        if (plan.Change?.Parameter is FlownParameter changed
            && (changed.Of(wing) < (float)changed.Min || changed.Of(wing) > (float)changed.Max))
        {
            return false;
        }
        return s_Elasticity.Contains((float)(wing.Stiffness.elasticity * plan.Elasticity))
            && s_Density.Contains(wing.Size.RelativeDensity) && s_Reference.Contains(wing.ReferenceFrequency);
    }

    // Wings of the user's own are of the first kinds.
    private static List<WingPreset> Wings(FlightPlan plan) =>
        KnownSpecies.With(plan.Definition, plan.Variant).Wings.Take(plan.MeshFile == null ? int.MaxValue : plan.OwnWings)
            .Select(wing => wing.CreatePreset(plan.Preset, plan.Variant)).ToList();

    private static WingParameterRange Range(string name) => WingParameterRange.All.First(range => range.Name == name);
}
