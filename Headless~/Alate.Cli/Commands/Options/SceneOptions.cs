using System.CommandLine;
using System.CommandLine.Parsing;

namespace Alate.Cli;

/// <summary>Options of a film that shows a sample scene.</summary>
internal sealed class SceneOptions
{
    private const double k_MostDegrees = 360.0, k_MostDistance = 1000.0;

    private readonly Option<string> m_Scene = new("--scene")
    {
        HelpName = "NAME",
        Description = $"A sample scene of the package plays in real time, in place of an insect: {SampleScene.Names}.",
    };

    private readonly Option<double?> m_Seconds = Numbers.Optional("--seconds", "S", 0.1, SceneFilmPlan.MostSeconds,
        $"Seconds of the scene, 0.1 to {SceneFilmPlan.MostSeconds}. [default: {SceneFilmPlan.DefaultSeconds}]");

    private readonly Option<double?> m_After = Numbers.Optional("--after", "S", 0.0, SceneFilmPlan.MostSeconds,
        $"Seconds that go by in the scene before the film begins, 0 to {SceneFilmPlan.MostSeconds}. [default: 0]");

    private readonly Option<string[]> m_Set = new("--set")
    {
        HelpName = "LABEL=VALUE",
        Arity = ArgumentArity.OneOrMore,
        AllowMultipleArgumentsPerToken = false,
        Description = "Moves a slider of the scene's own panel, or presses a button of it by its words. May be given several times.",
    };

    private readonly Option<double[]> m_Look = new("--look")
    {
        HelpName = "YAW,PITCH,DISTANCE[,X,Y,Z]",
        Description = "Where the camera of the scene looks: degrees to the side, degrees down, units to the point it looks at, and that "
            + "point.",
        CustomParser = Look,
    };

    private readonly Option<int?> m_Exposures = Numbers.OptionalCount("--exposures", "N", 1, SceneFilmPlan.MostExposures,
        $"Moments that blur into a frame of the scene, 1 to {SceneFilmPlan.MostExposures}. [default: 1]");

    /// <summary>All of them.</summary>
    public IReadOnlyList<Option> All => [m_Scene, m_Seconds, m_After, m_Set, m_Look, m_Exposures];

    /// <summary>The film that is asked for; null where no scene is.</summary>
    /// <exception cref="UserException">There is no such scene, or options of a scene are given without one.</exception>
    public SceneFilmPlan Plan(ParseResult parsed)
    {
        string name = parsed.GetValue(m_Scene);
        if (name == null)
        {
            Option alone = All.FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false });
            return alone == null ? null : throw new UserException($"{alone.Name} goes with --scene NAME.");
        }

        return new SceneFilmPlan
        {
            Scene = SampleScene.Find(name),
            Seconds = parsed.GetValue(m_Seconds) ?? SceneFilmPlan.DefaultSeconds,
            After = parsed.GetValue(m_After) ?? 0.0,
            Settings = parsed.GetValue(m_Set) ?? [],
            Look = parsed.GetValue(m_Look) ?? [],
            Exposures = parsed.GetValue(m_Exposures) ?? 1,
        };
    }

    private static double[] Look(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        double[] numbers = NumberText.WithCommas(text);
        if (numbers is [double yaw, double pitch, double distance, .. double[] target] && Math.Abs(yaw) <= k_MostDegrees
            && Math.Abs(pitch) <= 89.0 && distance is >= 0.05 and <= k_MostDistance && (target.Length is 0 or 3)
            && target.All(one => Math.Abs(one) <= k_MostDistance))
        {
            return numbers;
        }

        result.AddError($"--look takes degrees to the side (-{k_MostDegrees} to {k_MostDegrees}), degrees down (-89 to 89) and units (0.05 "
            + $"to {k_MostDistance}) with commas, such as 145,25,30, and the point as three more, not {Quote.Of(text)}.");
        return null;
    }
}
