using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>The live behaviours, by execution order, then in the order in which they were enabled.</summary>
internal static class BehaviourList
{
    private static readonly List<MonoBehaviour> s_Live = [];
    private static readonly List<MonoBehaviour> s_Round = [];
    private static readonly Comparison<MonoBehaviour> s_ByOrder = Compare;
    private static readonly IComparer<MonoBehaviour> s_Comparer = Comparer<MonoBehaviour>.Create(s_ByOrder);
    private static long s_Turns;

    public static void Add(MonoBehaviour behaviour)
    {
        behaviour.Turn = ++s_Turns;
        int place = s_Live.BinarySearch(behaviour, s_Comparer);
        s_Live.Insert(~place, behaviour);
    }

    public static void Remove(MonoBehaviour behaviour)
    {
        int place = s_Live.BinarySearch(behaviour, s_Comparer);
        if (place >= 0)
            s_Live.RemoveAt(place);
    }

    /// <summary>Sends each a message that is live now and still is when its turn comes.</summary>
    public static void Send(Func<BehaviourMessages, Action> message)
    {
        s_Round.Clear();
        s_Round.AddRange(s_Live);
        foreach (MonoBehaviour behaviour in s_Round)
        {
            if (!behaviour.Live || !behaviour.HearsMessages)
                continue;
            Action action = message(behaviour.Messages);
            if (action == null)
                continue;
            Lifecycle.Start(behaviour);
            if (behaviour.Live)
                behaviour.Messages.Send(action);
        }

        s_Round.Clear();
    }

    /// <summary>Returns true where any live behaviour has a method for a message.</summary>
    public static bool AnyHears(Func<BehaviourMessages, Action> message)
    {
        foreach (MonoBehaviour behaviour in s_Live)
        {
            if (behaviour.HearsMessages && message(behaviour.Messages) != null)
                return true;
        }

        return false;
    }

    /// <summary>Starts those that are live and not yet started.</summary>
    public static void StartNew()
    {
        s_Round.Clear();
        foreach (MonoBehaviour behaviour in s_Live)
        {
            if (!behaviour.Started && behaviour.HearsMessages)
                s_Round.Add(behaviour);
        }

        foreach (MonoBehaviour behaviour in s_Round)
            Lifecycle.Start(behaviour);
        s_Round.Clear();
    }

    /// <summary>Puts behaviours that awake together into their order.</summary>
    public static void Sort(List<MonoBehaviour> batch)
    {
        for (int i = 0; i < batch.Count; i++)
            batch[i].Turn = s_Turns + 1 + i;
        batch.Sort(s_ByOrder);
    }

    /// <summary>All that are live, for messages to everyone.</summary>
    public static MonoBehaviour[] Snapshot() => [.. s_Live];

    private static int Compare(MonoBehaviour a, MonoBehaviour b)
    {
        int byOrder = a.Messages.Order.CompareTo(b.Messages.Order);
        return byOrder != 0 ? byOrder : a.Turn.CompareTo(b.Turn);
    }
}
