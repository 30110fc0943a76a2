using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Renderers that the cameras see, by their bounds.</summary>
internal static class Visibility
{
    private static readonly List<Renderer> s_Renderers = [];
    private static readonly Plane[] s_Planes = new Plane[6];
    private static readonly List<Renderer> s_Round = [];
    private static readonly List<bool> s_Seen = [];

    public static void Add(Renderer renderer) => s_Renderers.Add(renderer);

    public static void Remove(Renderer renderer) => s_Renderers.Remove(renderer);

    /// <summary>Sends OnBecameVisible and OnBecameInvisible at the end of a frame.</summary>
    public static void Update()
    {
        s_Round.Clear();
        s_Round.AddRange(s_Renderers);
        s_Seen.Clear();
        for (int i = 0; i < s_Round.Count; i++)
            s_Seen.Add(false);
        foreach (Camera camera in Camera.Living)
        {
            if (camera.EnabledFlag && camera.Owner.ActiveFlag)
                Look(camera);
        }

        for (int i = 0; i < s_Round.Count; i++)
            Tell(s_Round[i], s_Seen[i]);
    }

    private static void Look(Camera camera)
    {
        GeometryUtility.CalculateFrustumPlanes(camera, s_Planes);
        for (int i = 0; i < s_Round.Count; i++)
        {
            Renderer renderer = s_Round[i];
            if (!s_Seen[i] && renderer.IsDrawn && (camera.cullingMask & (1 << renderer.Owner.layer)) != 0)
                s_Seen[i] = GeometryUtility.TestPlanesAABB(s_Planes, renderer.bounds);
        }
    }

    private static void Tell(Renderer renderer, bool visible)
    {
        if (renderer.IsDestroyed || renderer.VisibleFlag == visible)
            return;
        renderer.VisibleFlag = visible;
        foreach (MonoBehaviour behaviour in renderer.Owner.GetComponents<MonoBehaviour>())
        {
            if (behaviour.HearsMessages)
                behaviour.Messages.Send(visible ? "OnBecameVisible" : "OnBecameInvisible");
        }
    }
}
