namespace Unity.StandIns;

/// <summary>The order of the indices of a parallel job, and of jobs that do not depend on each other.</summary>
[StandInExtension]
public enum JobOrder
{
    Ascending,

    /// <summary>Single indices in another order each time, independent jobs in any.</summary>
    Shuffled,
}
