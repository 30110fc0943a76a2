using System;
using System.Collections;
using System.Reflection;

namespace UnityEngine;

/// <summary>The messages that one object answers, found by name as Unity finds them, whatever their access.</summary>
internal sealed class BehaviourMessages
{
    private readonly Object _target;

    public BehaviourMessages(Object target)
    {
        _target = target;
        Type type = target.GetType();
        Order = type.GetCustomAttribute<DefaultExecutionOrder>(true)?.order ?? 0;
        InEditMode = type.IsDefined(typeof(ExecuteAlways), true) || type.IsDefined(typeof(ExecuteInEditMode), true);
        Awake = Bind("Awake");
        OnEnable = Bind("OnEnable");
        OnDisable = Bind("OnDisable");
        OnDestroy = Bind("OnDestroy");
        FixedUpdate = Bind("FixedUpdate");
        Update = Bind("Update");
        LateUpdate = Bind("LateUpdate");
        OnGUI = Bind("OnGUI");
        Start = Bind("Start");
        StartRoutine = Start == null ? Find("Start", typeof(IEnumerator))?.CreateDelegate<Func<IEnumerator>>(target) : null;
    }

    public int Order { get; }
    public bool InEditMode { get; }
    public Action Awake { get; }
    public Action OnEnable { get; }
    public Action Start { get; }
    public Func<IEnumerator> StartRoutine { get; }
    public Action FixedUpdate { get; }
    public Action Update { get; }
    public Action LateUpdate { get; }
    public Action OnGUI { get; }
    public Action OnDisable { get; }
    public Action OnDestroy { get; }

    /// <summary>Sends a message; what it throws is logged. False if it threw.</summary>
    public bool Send(Action message)
    {
        if (message == null)
            return true;
        try
        {
            message();
            return true;
        }
        catch (Exception e)
        {
            Debug.LogException(e, _target);
            return false;
        }
    }

    /// <summary>Sends a message that comes too seldom to be kept.</summary>
    public void Send(string message) => Send(Bind(message));

    private Action Bind(string name) => Find(name, typeof(void))?.CreateDelegate<Action>(_target);

    private MethodInfo Find(string name, Type returns)
    {
        const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        for (Type type = _target.GetType(); type != null && type != typeof(Object); type = type.BaseType)
        {
            MethodInfo method = type.GetMethod(name, own, Type.EmptyTypes);
            if (method != null)
                return method.ReturnType == returns ? method : null;
        }

        return null;
    }
}
