namespace UnityEngine;

/// <summary>A contact, as messages tell of it; nothing here makes one.</summary>
public class Collision
{
    public Collider collider => null;
}
