using System;
using Unity.Jobs;

namespace Unity.Collections;

/// <summary>Finds out and says why an access was refused.</summary>
internal static class SafetyErrors
{
    /// <summary>Exception to throw where a handle has refused an access.</summary>
    public static Exception Of(in SafetyHandle handle, string name, bool writes)
    {
        if (!handle.Exists)
            return Disposed(name);
        if ((writes ? handle.writeKey : handle.readKey) == SafetyHandle.Denied)
        {
            (string job, string field) = JobLayout.Describe(handle.slot);
            return new InvalidOperationException(
                $"The {name} {job}.{field} is declared {(writes ? "[ReadOnly]" : "[WriteOnly]")} in the job, which must not "
                + $"{(writes ? "write" : "read")} it.");
        }

        JobRecord pending = ContainerSafety.Of(handle).FindConflict(writes, default, out bool otherWrites);
        return new InvalidOperationException(
            $"The scheduled job {pending?.Name} {(otherWrites ? "writes to" : "reads from")} the "
            + $"{name}. Call Complete() on the job's handle "
            + $"before you {(writes ? "write to" : "read from")} it.");
    }

    /// <summary>Memory may be freed if it is alive and no pending job uses it, or only jobs that the dependency waits for.</summary>
    public static void CheckRelease(in SafetyHandle handle, string name, JobHandle dependency)
    {
        if (!handle.Exists)
            throw Disposed(name);
        if (handle.IsOfJob)
            throw new InvalidOperationException($"A job must not dispose of the {name} that was passed to it.");
        JobRecord pending = ContainerSafety.Of(handle).FindConflict(true, dependency, out _);
        if (pending != null)
        {
            throw new InvalidOperationException(
                $"The scheduled job {pending.Name} uses the {name}. Call Complete() on the job's handle before you dispose of it.");
        }
    }

    private static ObjectDisposedException Disposed(string name) =>
        new(name, $"The {name} has been disposed of, it must not be used.");
}
