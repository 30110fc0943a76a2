using System;
using System.Collections.Generic;

using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>What one step of undo takes back.</summary>
internal sealed class UndoGroup
{
    private readonly List<ObjectState> _states = [];
    private readonly List<Object> _made = [];

    public UndoGroup(int number, string name)
    {
        Number = number;
        Name = name;
    }

    public int Number { get; }
    public string Name { get; set; }
    public bool IsEmpty => _states.Count == 0 && _made.Count == 0 && !Destroyed;

    /// <summary>Whether something was destroyed, which this stand-in cannot bring back.</summary>
    public bool Destroyed { get; set; }

    /// <summary>Keeps the first state of each object.</summary>
    public void Record(Object target)
    {
        if (!_states.Exists(state => ReferenceEquals(state.Target, target)))
            _states.Add(ObjectState.Of(target));
    }

    public void RecordMade(Object made) => _made.Add(made);

    public void Take(UndoGroup later)
    {
        foreach (ObjectState state in later._states)
        {
            if (!_states.Exists(known => ReferenceEquals(known.Target, state.Target)))
                _states.Add(state);
        }

        _made.AddRange(later._made);
        Destroyed |= later.Destroyed;
    }

    /// <summary>Takes everything back; says how to do it again.</summary>
    public UndoGroup Revert()
    {
        if (Destroyed)
            throw new NotSupportedException("The stand-in for Undo cannot bring destroyed objects back.");
        var again = new UndoGroup(Number, Name);
        foreach (ObjectState state in _states)
        {
            if (state.Target != null)
                again.Record(state.Target);
        }

        for (int i = _states.Count - 1; i >= 0; i--)
            _states[i].Restore();
        foreach (Object made in _made)
        {
            if (made != null)
                Object.DestroyImmediate(made);
        }

        return again;
    }
}
