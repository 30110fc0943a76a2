using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>One thing that can be taken back.</summary>
internal abstract class UndoStep
{
    /// <summary>Object of the step; null where nothing more can be recorded of it.</summary>
    public virtual Object Target => null;

    /// <summary>Returns true where there is a change to revert.</summary>
    public virtual bool IsStale() => true;

    /// <summary>Takes it back.</summary>
    public abstract void Restore();

    /// <summary>A step that does it again; null where there is none.</summary>
    public virtual UndoStep Again() => null;

    /// <summary>The state of an object now.</summary>
    public static UndoStep Of(Object target) =>
        target is MonoBehaviour or ScriptableObject ? new SavedState(target) : new ComponentStep(ObjectState.Of(target));

    private sealed class ComponentStep(ObjectState state) : UndoStep
    {
        public override Object Target => state.Target;

        public override void Restore() => state.Restore();

        public override UndoStep Again() => state.Target == null ? null : Of(state.Target);
    }
}

/// <summary>Creation of an object.</summary>
internal sealed class MadeStep(Object made) : UndoStep
{
    public override void Restore()
    {
        if (made != null)
            Object.DestroyImmediate(made);
    }
}

/// <summary>Destruction of an object, which this stand-in cannot bring back.</summary>
internal sealed class DestroyedStep : UndoStep
{
    public override void Restore() => throw new NotSupportedException("The stand-in for Undo cannot bring destroyed objects back.");
}
