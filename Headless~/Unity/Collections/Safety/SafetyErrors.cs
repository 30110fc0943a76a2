using System;
using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using Unity.Jobs;

namespace Unity.Collections;

/// <summary>Finds out and says why an access was refused.</summary>
internal static class SafetyErrors
{
    [DoesNotReturn]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Throw(in SafetyHandle handle, string name, bool writes)
    {
        CheckExists(handle, name);
        int denied = writes ? SafetyHandle.WriteDenied : SafetyHandle.ReadDenied;
        if ((handle.obeys & denied) != 0)
        {
            var (job, field) = JobLayout.Describe(handle.obeys >> SafetyHandle.FieldShift);
            throw new InvalidOperationException(
                $"The {name} {job}.{field} is declared {(writes ? "[ReadOnly]" : "[WriteOnly]")} in the job, which must not {(writes ? "write" : "read")} it.");
        }

        var pending = ContainerSafety.Of(handle).FindConflict(writes, default, out bool otherWrites);
        throw new InvalidOperationException(
            $"The scheduled job {pending?.Name} {(otherWrites ? "writes to" : "reads from")} the {name}. Call Complete() on the job's handle "
            + $"before you {(writes ? "write to" : "read from")} it.");
    }

    /// <summary>Memory may be freed if it is alive and no pending job uses it, or only jobs that the dependency waits for.</summary>
    public static void CheckRelease(in SafetyHandle handle, string name, JobHandle dependency)
    {
        CheckExists(handle, name);
        if (handle.IsOfJob)
            throw new InvalidOperationException($"A job must not dispose of the {name} that was passed to it.");
        var pending = ContainerSafety.Of(handle).FindConflict(true, dependency, out _);
        if (pending != null)
            throw new InvalidOperationException(
                $"The scheduled job {pending.Name} uses the {name}. Call Complete() on the job's handle before you dispose of it.");
    }

    private static void CheckExists(in SafetyHandle handle, string name)
    {
        if (!handle.Exists)
            throw new ObjectDisposedException(name, $"The {name} has been disposed of, it must not be used.");
    }
}
