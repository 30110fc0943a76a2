using System;
using System.Collections;

namespace UnityEngine;

public class YieldInstruction;

public sealed class WaitForSeconds(float seconds) : YieldInstruction
{
    internal float Seconds { get; } = seconds;
}

public sealed class WaitForFixedUpdate : YieldInstruction;

public sealed class WaitForEndOfFrame : YieldInstruction;

public abstract class CustomYieldInstruction : IEnumerator
{
    public abstract bool keepWaiting { get; }

    public object Current => null;

    public bool MoveNext() => keepWaiting;

    public virtual void Reset()
    {
    }
}

public sealed class WaitUntil(Func<bool> predicate) : CustomYieldInstruction
{
    public override bool keepWaiting => !predicate();
}

public sealed class WaitWhile(Func<bool> predicate) : CustomYieldInstruction
{
    public override bool keepWaiting => predicate();
}

public class WaitForSecondsRealtime(float time) : CustomYieldInstruction
{
    private double _until = -1.0;

    public float waitTime { get; set; } = time;

    public override bool keepWaiting
    {
        get
        {
            if (_until < 0.0)
                _until = Time.unscaledTimeAsDouble + waitTime;
            bool waits = Time.unscaledTimeAsDouble < _until;
            if (!waits)
                Reset();
            return waits;
        }
    }

    public override void Reset() => _until = -1.0;
}

public class AsyncOperation : YieldInstruction
{
    public event Action<AsyncOperation> completed
    {
        add => value(this);
        remove { }
    }

    public bool isDone => true;

    public float progress => 1f;
}
