using System.Runtime.InteropServices;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Textures of a sample that the page has, by numbers. Joints, which move, are sent with each state; all others once.</summary>
internal sealed class SampleMaps
{
    private const uint k_Colours = 0, k_Numbers = 1;

    private readonly Dictionary<Texture2D, uint> m_Numbers = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<uint, (Texture2D Texture, uint Kind)> m_New = [];
    private uint m_Count;

    /// <summary>Notes a texture of colours for the next state.</summary>
    /// <returns>Its number; 0 for no texture.</returns>
    public uint SeePicture(Texture2D texture) => See(texture, k_Colours, isMoving: false);

    /// <summary>Notes a texture of numbers for the next state.</summary>
    /// <param name="texture">The texture; null for none.</param>
    /// <param name="isMoving">True for joints.</param>
    /// <returns>Its number; 0 for no texture.</returns>
    public uint SeeNumbers(Texture2D texture, bool isMoving) => See(texture, k_Numbers, isMoving);

    /// <summary>Writes the textures that the page needs and the numbers of those that are gone.</summary>
    public void Write(StateBuffer state)
    {
        state.Add((uint)m_New.Count);
        foreach ((uint number, (Texture2D texture, uint kind)) in m_New)
        {
            state.Add(number);
            state.Add(kind);
            state.Add((uint)texture.width);
            state.Add((uint)texture.height);
            Color[] texels = texture.CopyPixels();
            state.Add(kind == k_Numbers
                ? MemoryMarshal.AsBytes(texels.AsSpan())
                : MemoryMarshal.AsBytes(Array.ConvertAll(texels, texel => (Color32)texel).AsSpan()));
        }

        m_New.Clear();
        Texture2D[] gone = [.. m_Numbers.Keys.Where(texture => texture == null)];
        state.Add((uint)gone.Length);
        foreach (Texture2D texture in gone)
        {
            state.Add(m_Numbers[texture]);
            m_Numbers.Remove(texture);
        }
    }

    private uint See(Texture2D texture, uint kind, bool isMoving)
    {
        if (texture == null)
            return 0;
        bool isKnown = m_Numbers.TryGetValue(texture, out uint number);
        if (!isKnown)
            m_Numbers.Add(texture, number = ++m_Count);
        if (!isKnown || isMoving)
            m_New[number] = (texture, kind);
        return number;
    }
}
