using System;
using System.Collections.Generic;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Steps that can be undone and redone, in groups that go together.</summary>
internal sealed class UndoHistory
{
    private readonly List<Step> _done = [];
    private readonly List<Step> _undone = [];

    public int CurrentGroup { get; private set; }

    public string CurrentGroupName { get; set; } = "";

    public void Increment()
    {
        Flush();
        CurrentGroup++;
        CurrentGroupName = "";
    }

    /// <summary>Keeps an object's state.</summary>
    /// <param name="target">The object.</param>
    /// <param name="name">What the group is called from now on.</param>
    /// <param name="always">Whether it counts as a step even if the object does not change.</param>
    public void Record(Object target, string name, bool always)
    {
        ArgumentNullException.ThrowIfNull(target);
        CurrentGroupName = name;
        bool known = _done.Exists(step => step.Group == CurrentGroup && ReferenceEquals(step.State.Target, target));
        if (!known)
            _done.Add(new Step { Group = CurrentGroup, State = UndoStep.Of(target), Kept = always });
        _undone.Clear();
    }

    /// <summary>Keeps a step that is none of a state.</summary>
    public void Add(UndoStep step, string name)
    {
        CurrentGroupName = name;
        _done.Add(new Step { Group = CurrentGroup, State = step, Kept = true });
        _undone.Clear();
    }

    public void Collapse(int group)
    {
        Flush();
        foreach (Step step in _done)
            step.Group = Math.Min(step.Group, Math.Max(group, 0));
    }

    /// <summary>Takes back everything since a group began, for good.</summary>
    public void Revert(int group)
    {
        Flush();
        while (_done.Count > 0 && _done[^1].Group >= group)
        {
            _done[^1].State.Restore();
            _done.RemoveAt(_done.Count - 1);
        }
    }

    public bool Undo() => Turn(_done, _undone);

    public bool Redo() => Turn(_undone, _done);

    public void Clear()
    {
        _done.Clear();
        _undone.Clear();
    }

    private bool Turn(List<Step> from, List<Step> to)
    {
        Flush();
        if (from.Count == 0)
            return false;
        int group = from[^1].Group;
        while (from.Count > 0 && from[^1].Group == group)
        {
            Step step = from[^1];
            from.RemoveAt(from.Count - 1);
            UndoStep again = step.State.Again();
            step.State.Restore();
            if (again != null)
                to.Add(new Step { Group = group, State = again, Kept = true });
        }

        CurrentGroup++;
        return true;
    }

    // What was recorded but did not change is no step.
    private void Flush()
    {
        _done.RemoveAll(step => !step.Kept && !step.State.IsStale());
        foreach (Step step in _done)
            step.Kept = true;
    }

    private sealed class Step
    {
        public int Group;
        public UndoStep State;
        public bool Kept;
    }
}
