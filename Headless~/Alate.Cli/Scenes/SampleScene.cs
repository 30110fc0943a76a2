using Alate.Samples;

namespace Alate.Cli;

/// <summary>Scene of a sample of the package.</summary>
/// <param name="Name">On the command line.</param>
/// <param name="Folder">Of the sample.</param>
/// <param name="Script">The component that makes the scene.</param>
internal sealed record SampleScene(string Name, string Folder, Type Script)
{
    public static readonly IReadOnlyList<SampleScene> All =
    [
        new("comparison", "Comparison", typeof(ComparisonSample)),
        new("garden", "Garden", typeof(GardenSample)),
        new("insects", "Insects", typeof(InsectsSample)),
        new("meadow", "Meadow", typeof(MeadowSample)),
        new("monarch", "Monarch", typeof(MonarchSample)),
        new("own-wing", "YourOwnWing", typeof(OwnWingSample)),
        new("swarm", "Swarm", typeof(SwarmSample)),
    ];

    /// <summary>All names, with commas.</summary>
    public static string Names => string.Join(", ", All.Select(scene => scene.Name));

    /// <summary>Scene of a name.</summary>
    /// <exception cref="UserException">There is none.</exception>
    public static SampleScene Find(string name) =>
        All.FirstOrDefault(scene => scene.Name.Equals(name, StringComparison.OrdinalIgnoreCase))
        ?? throw new UserException($"There is no scene {Quote.Of(name)}. There are: {Names}.");
}
