using System;
using System.Collections.Generic;

namespace UnityEngine.Events;

public delegate void UnityAction();

public delegate void UnityAction<T0>(T0 arg0);

public delegate void UnityAction<T0, T1>(T0 arg0, T1 arg1);

/// <summary>Listeners added by script; those of the inspector are not here.</summary>
[Serializable]
public abstract class UnityEventBase
{
    private protected readonly List<Delegate> Listeners = [];

    public void RemoveAllListeners() => Listeners.Clear();

    public int GetPersistentEventCount() => 0;

    // What one listener throws does not keep the others from hearing.
    private protected void Call(Action<Delegate> call)
    {
        foreach (Delegate listener in Listeners.ToArray())
        {
            try
            {
                call(listener);
            }
            catch (Exception e)
            {
                Debug.LogException(e);
            }
        }
    }
}

[Serializable]
public class UnityEvent : UnityEventBase
{
    public void AddListener(UnityAction call) => Listeners.Add(call);
    public void RemoveListener(UnityAction call) => Listeners.Remove(call);
    public void Invoke() => Call(l => ((UnityAction)l)());
}

[Serializable]
public class UnityEvent<T0> : UnityEventBase
{
    public void AddListener(UnityAction<T0> call) => Listeners.Add(call);
    public void RemoveListener(UnityAction<T0> call) => Listeners.Remove(call);
    public void Invoke(T0 arg0) => Call(l => ((UnityAction<T0>)l)(arg0));
}
