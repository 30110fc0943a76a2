using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.StandIns;

/// <summary>Reloads scripts as Unity does when they are compiled again during play.</summary>
[StandInExtension]
public static class DomainReload
{
    /// <summary>
    /// Objects hear OnDisable, lose what Unity cannot write, and hear OnEnable, but neither Awake nor Start. Static state begins again: the
    /// methods that clear it when play begins without a reload stand for that.
    /// </summary>
    public static void Run()
    {
        List<MonoBehaviour> live = [.. BehaviourList.Snapshot()];
        List<ScriptableObject> assets = ObjectRegistry.Find<ScriptableObject>(typeof(ScriptableObject));
        foreach (MonoBehaviour behaviour in live)
            Lifecycle.Deactivate(behaviour);
        foreach (ScriptableObject asset in assets)
            new BehaviourMessages(asset).Send("OnDisable");

        Application.ForgetListeners();
        LoadMethods.Run(RuntimeInitializeLoadType.SubsystemRegistration);
        foreach (MonoBehaviour behaviour in ObjectRegistry.Find<MonoBehaviour>(typeof(MonoBehaviour)))
            LoseUnsaved(behaviour);
        foreach (ScriptableObject asset in assets)
            LoseUnsaved(asset);

        foreach (ScriptableObject asset in assets)
            new BehaviourMessages(asset).Send("OnEnable");
        Lifecycle.Activate(live);
    }

    // What a new object of the type has there.
    private static void LoseUnsaved(Object survivor)
    {
        Object fresh = Factory.Make<Object>(survivor.GetType());
        const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        for (Type type = survivor.GetType(); type.Assembly != typeof(Object).Assembly; type = type.BaseType)
        {
            foreach (FieldInfo field in type.GetFields(own))
            {
                if (!SerializedFields.SurvivesReload(field))
                    field.SetValue(survivor, field.GetValue(fresh));
            }
        }

        fresh.MarkDestroyed();
    }
}
