using System;
using NUnit.Framework;
using NUnit.Framework.Constraints;
using Unity.StandIns;

namespace UnityEngine.TestTools.Constraints;

/// <summary>Constraint that a delegate allocates managed memory on the calling thread.</summary>
public class AllocatingGCMemoryConstraint : Constraint
{
    public override string Description => "allocates GC memory";

    // Unity's NUnit takes an object.
    [StandInExtension]
    public override ConstraintResult ApplyTo<TActual>(TActual actual)
    {
        ArgumentNullException.ThrowIfNull(actual);
        return actual is TestDelegate code
            ? Measure(() => code(), actual)
            : throw new ArgumentException($"The actual value must be a TestDelegate, is {actual.GetType()}.", nameof(actual));
    }

    public override ConstraintResult ApplyTo<TActual>(ActualValueDelegate<TActual> del) => Measure(() => del(), del);

    private ConstraintResult Measure(Action code, object actual)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        code();
        long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        return new Result(this, actual, bytes);
    }

    private sealed class Result(IConstraint constraint, object actual, long bytes) : ConstraintResult(constraint, actual, bytes > 0)
    {
        public override void WriteMessageTo(MessageWriter writer) =>
            writer.WriteMessageLine($"The delegate allocated {bytes} bytes of GC memory.");
    }
}
