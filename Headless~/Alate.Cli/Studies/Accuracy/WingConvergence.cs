namespace Alate.Cli;

/// <summary>Convergence of one kind of wing.</summary>
/// <param name="Name">The kind.</param>
/// <param name="Points">Both schemes, each in order of substeps; these are what the wing takes, which fast air makes more than it is told
/// to.</param>
/// <param name="AtDefaults">The wing as it flies by default.</param>
/// <param name="Version01">Version 0.1 at its defaults, but with today's patches; cost 1.</param>
/// <param name="Values">Numbers of its beat; those of the whole insect with the first kind.</param>
internal sealed record WingConvergence(
    string Name,
    IReadOnlyList<ConvergencePoint> Points,
    ConvergencePoint AtDefaults,
    ConvergencePoint Version01,
    IReadOnlyList<ConvergedValue> Values)
{
    /// <summary>The points of one scheme.</summary>
    public List<ConvergencePoint> By(TimeScheme scheme) => Points.Where(point => point.Scheme == scheme).ToList();
}
