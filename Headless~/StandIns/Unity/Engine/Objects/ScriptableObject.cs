using System;

namespace UnityEngine;

public class ScriptableObject : Object
{
    private bool _ended;

    public ScriptableObject() => Factory.Announce(this, "Use ScriptableObject.CreateInstance.");

    public static T CreateInstance<T>() where T : ScriptableObject => (T)CreateInstance(typeof(T));

    /// <summary>Null, as in Unity for a name that no class has: only pipelines are made by their names.</summary>
    public static ScriptableObject CreateInstance(string className) => null;

    public static ScriptableObject CreateInstance(Type type)
    {
        if (!typeof(ScriptableObject).IsAssignableFrom(type) || type.IsAbstract)
            throw new ArgumentException($"{type.Name} is not a ScriptableObject that can be created.", nameof(type));
        ScriptableObject instance = Factory.Make<ScriptableObject>(type);
        instance.Begin();
        return instance;
    }

    internal void Begin()
    {
        var messages = new BehaviourMessages(this);
        messages.Send(messages.Awake);
        messages.Send(messages.OnEnable);
    }

    internal void End()
    {
        if (_ended)
            return;
        _ended = true;
        var messages = new BehaviourMessages(this);
        messages.Send(messages.OnDisable);
        messages.Send(messages.OnDestroy);
        MarkDestroyed();
    }
}
