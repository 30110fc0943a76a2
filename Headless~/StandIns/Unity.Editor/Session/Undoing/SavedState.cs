using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>A copy of all that Unity would save of an object.</summary>
internal sealed class SavedState : UndoStep
{
    private static readonly Dictionary<Object, Object> s_None = [];

    private readonly Object _target;
    private readonly object _fields;
    private readonly string _name;

    public SavedState(Object target)
    {
        _target = target;
        _name = target.name;
        _fields = RuntimeHelpers.GetUninitializedObject(target.GetType());
        GC.SuppressFinalize(_fields);
        Copying.Fields(target, _fields, s_None);
    }

    public override Object Target => _target;

    /// <summary>Puts everything back; an object that was destroyed meanwhile stays so.</summary>
    public override void Restore()
    {
        if (_target == null)
            return;
        _target.name = _name;
        Copying.Fields(_fields, _target, s_None);
    }

    public override UndoStep Again() => _target == null ? null : new SavedState(_target);

    /// <summary>Returns true where the object differs from this copy.</summary>
    public override bool IsStale() => _target != null && (_target.name != _name || !Same(_fields, new SavedState(_target)._fields));

    private static bool Same(object a, object b)
    {
        if (a is null || b is null || a is Object || a.GetType().IsPrimitive || a.GetType().IsEnum || a is string)
            return ReferenceEquals(a, b) || Equals(a, b);
        if (a is IList x && b is IList y)
        {
            bool same = x.Count == y.Count;
            for (int k = 0; same && k < x.Count; k++)
                same = Same(x[k], y[k]);
            return same;
        }

        return SameFields(a, b);
    }

    private static bool SameFields(object a, object b)
    {
        foreach (FieldInfo field in SerializedFields.Of(a.GetType()))
        {
            if (!Same(field.GetValue(a), field.GetValue(b)))
                return false;
        }

        return true;
    }
}
