namespace Alate.Mutations.Trials;

/// <summary>
/// Found by a law, found by nothing but a number which the program printed once, or not found.
/// </summary>
internal enum Outcome
{
    Found,
    FoundByNumber,
    Survived,
    NotReached,
    Equivalent,
}

/// <summary>Fate of a mutant.</summary>
/// <param name="How">The test that found it and its message, or the end of its process.</param>
internal sealed record Verdict(Outcome Outcome, string How);
