using System;
using System.Runtime.CompilerServices;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// State of an object that undo restores: its saved fields, and the part of the engine's own state that the editor changes.
/// </summary>
internal sealed class ObjectState
{
    private static readonly ConditionalWeakTable<GameObject, StrongBox<StaticEditorFlags>> s_Flags = [];

    private readonly Object _target;
    private readonly SerializedNode _fields;
    private readonly string _name;
    private readonly StaticEditorFlags _flags;
    private readonly Component _engine;

    private ObjectState(Object target)
    {
        _target = target;
        _name = target.name;
        _fields = SerializedNode.Of(target);
        _flags = target is GameObject gameObject ? FlagsOf(gameObject).Value : default;
        if (target is not IStateful stateful)
            return;
        _engine = Factory.Make<Component>(target.GetType());
        stateful.CopyStateTo(_engine);
    }

    public static ObjectState Of(Object target) => new(target ?? throw new ArgumentNullException(nameof(target)));

    /// <summary>Static flags of an object; the engine does not know them.</summary>
    public static StrongBox<StaticEditorFlags> FlagsOf(GameObject target) =>
        s_Flags.GetValue(target, _ => new StrongBox<StaticEditorFlags>());

    public Object Target => _target;

    /// <summary>Brings the state back; an object that is gone stays gone.</summary>
    public void Restore()
    {
        if (_target == null)
            return;
        if (_target is not Component)
            _target.name = _name;
        _fields.Write(_target, SerializedNode.Of(_target));
        if (_target is GameObject gameObject)
            FlagsOf(gameObject).Value = _flags;
        (_engine as IStateful)?.CopyStateTo((Component)_target);
        Unity.StandIns.EditorMessages.Validate(_target);
    }
}
