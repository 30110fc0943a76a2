namespace Alate.Mutations.Trials;

internal enum Outcome
{
    Found,
    Survived,
    NotReached,
    Equivalent,
}

/// <summary>Fate of a mutant.</summary>
/// <param name="How">The test that found it and its message, or the end of its process.</param>
internal sealed record Verdict(Outcome Outcome, string How);
