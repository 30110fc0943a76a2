namespace Alate.Mutations.Trials;

/// <summary>A line that a worker writes: a group begins, its class is set up, a test has ended, or all is done.</summary>
internal sealed record TestReport
{
    public const string Begin = "begin", SetUp = "set-up", Test = "test", Done = "done";

    public string Event { get; init; }

    /// <summary>Number of the group in the worker's plan.</summary>
    public int Group { get; init; }

    /// <summary>Full name of the test; of the class where its own set-up or tear-down failed.</summary>
    public string Name { get; init; }

    public bool Failed { get; init; }

    /// <summary>First line of what went wrong.</summary>
    public string Message { get; init; }

    /// <summary>Processor time of the test or set-up, seconds.</summary>
    public double Seconds { get; init; }

    /// <summary>Numbers of the mutants that the test met; null where they are not recorded.</summary>
    public int[] Hits { get; init; }

    /// <summary>Those of them that were met while a value was made that is kept; no other test meets them.</summary>
    public int[] Once { get; init; }
}
