using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Renderers by distance. The levels are kept; none is switched on or off.</summary>
public class LODGroup : Component, IStateful, IReferring
{
    private LOD[] _levels = [];

    public bool enabled { get; set; } = true;

    public int lodCount
    {
        get
        {
            CheckAlive();
            return _levels.Length;
        }
    }

    public LOD[] GetLODs()
    {
        CheckAlive();
        return Array.ConvertAll(_levels, l => l.Copy());
    }

    /// <summary>Each level must be for smaller objects on the screen than the one before it.</summary>
    public void SetLODs(LOD[] lods)
    {
        CheckAlive();
        for (int i = 1; i < lods.Length; i++)
        {
            if (lods[i].screenRelativeTransitionHeight >= lods[i - 1].screenRelativeTransitionHeight)
            {
                Debug.LogError("SetLODs: Attempting to set LOD where the screen relative size is greater then or equal to a higher "
                    + "detail LOD level.", this);
                return;
            }
        }

        _levels = Array.ConvertAll(lods, l => l.Copy());
    }

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (LODGroup)copy;
        to._levels = GetLODs();
        to.enabled = enabled;
    }

    void IReferring.Redirect(IReadOnlyDictionary<Object, Object> copies)
    {
        foreach (LOD level in _levels)
        {
            for (int i = 0; i < level.renderers.Length; i++)
                level.renderers[i] = (Renderer)Copying.Twin(level.renderers[i], copies);
        }
    }
}

public struct LOD(float screenRelativeTransitionHeight, Renderer[] renderers)
{
    public float screenRelativeTransitionHeight = screenRelativeTransitionHeight;
    public float fadeTransitionWidth;
    public Renderer[] renderers = renderers;

    internal readonly LOD Copy() => this with { renderers = [.. renderers ?? []] };
}
