using System.Collections.Generic;

namespace Alate.Mutations.Trials;

/// <summary>Tests of one class of tests, run one after the other.</summary>
/// <param name="Assembly">Name of the assembly.</param>
/// <param name="Type">Full name of the class.</param>
/// <param name="Tests">Full names of the tests; null for all.</param>
internal sealed record TestGroup(string Assembly, string Type, IReadOnlyList<string> Tests);
