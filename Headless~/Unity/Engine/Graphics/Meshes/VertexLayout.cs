using System;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Where each attribute of a vertex lies: its stream and its offset in bytes. Attributes are in the order of the enum.</summary>
internal sealed class VertexLayout
{
    public const int MaxStreams = 4;

    public static readonly VertexLayout Empty = new([]);

    private readonly int[] _offsets;
    private readonly int[] _strides;

    public VertexLayout(VertexAttributeDescriptor[] attributes)
    {
        Attributes = [.. attributes.OrderBy(a => a.attribute)];
        _offsets = new int[Attributes.Length];
        _strides = new int[attributes.Length == 0 ? 0 : attributes.Max(a => a.stream) + 1];
        for (int i = 0; i < Attributes.Length; i++)
        {
            VertexAttributeDescriptor attribute = Attributes[i];
            Check(attribute, i);
            _offsets[i] = _strides[attribute.stream];
            _strides[attribute.stream] += VertexFormats.Size(attribute.format) * attribute.dimension;
        }
    }

    public VertexAttributeDescriptor[] Attributes { get; }

    public int StreamCount => _strides.Length;

    public int Stride(int stream) => _strides[stream];

    public int Offset(int index) => _offsets[index];

    /// <summary>The place of the attribute in <see cref="Attributes"/>; -1 if there is none.</summary>
    public int IndexOf(VertexAttribute attribute)
    {
        for (int i = 0; i < Attributes.Length; i++)
        {
            if (Attributes[i].attribute == attribute)
                return i;
        }

        return -1;
    }

    /// <summary>The same layout with the attribute added to, or replaced in, the first stream.</summary>
    public VertexLayout With(VertexAttributeDescriptor added) =>
        new([.. Attributes.Where(a => a.attribute != added.attribute), added]);

    public VertexLayout Without(VertexAttribute removed) => new([.. Attributes.Where(a => a.attribute != removed)]);

    private void Check(VertexAttributeDescriptor attribute, int index)
    {
        if (index > 0 && Attributes[index - 1].attribute == attribute.attribute)
            throw new ArgumentException($"The vertex attribute {attribute.attribute} is there twice.");
        if (attribute.dimension is < 1 or > 4)
            throw new ArgumentException($"The vertex attribute {attribute} has a dimension outside 1 to 4.");
        if (attribute.stream is < 0 or >= MaxStreams)
            throw new ArgumentException($"The vertex attribute {attribute} has a stream outside 0 to {MaxStreams - 1}.");
        if (VertexFormats.Size(attribute.format) * attribute.dimension % 4 != 0)
            throw new ArgumentException($"The vertex attribute {attribute} has a size that is not a multiple of 4 bytes.");
    }
}
