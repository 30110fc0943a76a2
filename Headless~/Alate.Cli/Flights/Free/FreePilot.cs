using Alate.Flight;

namespace Alate.Cli;

/// <summary>A pilot that a user names: the option that says where to, and how the pilot is made of it.</summary>
/// <param name="Name">Name, as <c>--pilot</c> takes it.</param>
/// <param name="Takes">Options that go with this pilot alone.</param>
/// <param name="NeedsIt">True where the first of them has no default.</param>
/// <param name="Create">Makes the pilot of a plan, for the trims of the plan's insect.</param>
internal sealed record FreePilot(string Name, string[] Takes, bool NeedsIt, Func<FreePlan, TrimTable, IFlightPilot> Create)
{
    public static readonly FreePilot Hover = new("hover", [], false, (_, trims) => Visit([default], trims));
    public static readonly FreePilot GoTo = new("goto", ["--to"], true, (plan, trims) => Visit(plan.Points, trims));
    public static readonly FreePilot Points = new("points", ["--points"], true, (plan, trims) => Visit(plan.Points, trims));
    public static readonly FreePilot Wander = new("wander", ["--seed", "--erratic"], false,
        (plan, _) => new CoursePilot(plan.Seed, plan.Erratic));

    public static IReadOnlyList<FreePilot> All { get; } = [Hover, GoTo, Points, Wander];

    /// <summary>Finds a pilot by name.</summary>
    /// <exception cref="UserException">There is none of that name.</exception>
    public static FreePilot Find(string name)
    {
        return All.FirstOrDefault(pilot => pilot.Name == name) ?? throw new UserException(
            $"--pilot takes {string.Join(", ", All.SkipLast(1).Select(pilot => pilot.Name))} or {All[^1].Name}, not {Quote.Of(name)}.");
    }

    // What cannot stand still swims about instead.
    private static IFlightPilot Visit(IReadOnlyList<float3> points, TrimTable trims)
    {
        bool stays = points.Count == 1 && math.all(points[0] == 0f);
        return stays && trims.Speeds[0] > 0f ? new CoursePilot(1) : new PointPilot(points);
    }
}
