using System;
using System.Collections;
using System.Threading;

namespace UnityEngine;

public class MonoBehaviour : Behaviour
{
    private BehaviourMessages _messages;
    private CoroutineSet _coroutines;
    private CancellationTokenSource _destroyed;

    public bool runInEditMode { get; set; }

    public bool useGUILayout { get; set; } = true;

    /// <summary>Cancelled when the behaviour is destroyed.</summary>
    public CancellationToken destroyCancellationToken
    {
        get
        {
            CheckAlive();
            _destroyed ??= new CancellationTokenSource();
            return _destroyed.Token;
        }
    }

    internal BehaviourMessages Messages => _messages ??= new BehaviourMessages(this);

    internal bool Awoken { get; set; }
    internal bool Started { get; set; }

    /// <summary>True once the behaviour's end has begun: it gets no message but OnDisable and OnDestroy.</summary>
    internal bool Ended { get; set; }

    /// <summary>OnEnable was sent, OnDisable not yet.</summary>
    internal bool Live { get; set; }

    /// <summary>Rank among behaviours of equal execution order.</summary>
    internal long Turn { get; set; }

    internal bool HearsMessages => Application.isPlaying || runInEditMode || Messages.InEditMode;

    internal CoroutineSet Coroutines => _coroutines;

    public static void print(object message) => Debug.Log(message);

    public Coroutine StartCoroutine(IEnumerator routine)
    {
        CheckAlive();
        if (routine == null)
            throw new NullReferenceException("routine is null");
        if (!gameObject.activeInHierarchy)
        {
            Debug.LogError($"Coroutine couldn't be started because the the game object '{name}' is inactive!", this);
            return null;
        }

        _coroutines ??= new CoroutineSet(this);
        return _coroutines.Start(routine);
    }

    public void StopCoroutine(IEnumerator routine) => _coroutines?.Stop(c => c.Routine == routine);
    public void StopCoroutine(Coroutine routine) => _coroutines?.Stop(c => c == routine);
    public void StopAllCoroutines() => _coroutines?.Stop(_ => true);

    private protected override void EnabledChanged()
    {
        if (!gameObject.activeInHierarchy)
            return;
        if (EnabledFlag)
            Lifecycle.Activate(this);
        else
            Lifecycle.Deactivate(this);
    }

    private protected override void Released()
    {
        StopAllCoroutines();
        _destroyed?.Cancel();
    }
}
