using System;
using UnityEngine;

namespace StandIns;

/// <summary>Stand-in for the scene view's camera while a test draws and points.</summary>
public sealed class SceneEye : IDisposable
{
    private static SceneEye s_Current;

    /// <summary>Opens an eye until it is disposed.</summary>
    /// <param name="project">From the world to pixels, z the distance ahead.</param>
    /// <param name="through">The ray through a pixel.</param>
    public SceneEye(Func<Vector3, Vector3> project, Func<Vector2, Ray> through)
    {
        Project = project;
        Through = through;
        s_Current = this;
    }

    /// <summary>Size of a handle at a place; null where each is one unit large.</summary>
    public static Func<Vector3, float> HandleSize { get; set; }

    internal static SceneEye Needed => s_Current ?? throw UnityEditor.Absent.Editor;

    internal Func<Vector3, Vector3> Project { get; }

    internal Func<Vector2, Ray> Through { get; }

    /// <summary>Lets the event be handled as the scene view would send it, after the layout that goes before each.</summary>
    public void Send(Event sent, Action<Event> handle)
    {
        Event before = Event.current;
        try
        {
            foreach (Event one in new[] { new Event { type = EventType.Layout, mousePosition = sent.mousePosition }, sent })
            {
                Event.current = one;
                handle(one);
            }
        }
        finally
        {
            Event.current = before;
        }
    }

    public void Dispose() => s_Current = null;
}
