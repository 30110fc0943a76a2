using System;

namespace UnityEngine.Rendering;

public struct VertexAttributeDescriptor(
    VertexAttribute attribute = VertexAttribute.Position,
    VertexAttributeFormat format = VertexAttributeFormat.Float32,
    int dimension = 3,
    int stream = 0) : IEquatable<VertexAttributeDescriptor>
{
    public VertexAttribute attribute { get; set; } = attribute;
    public VertexAttributeFormat format { get; set; } = format;
    public int dimension { get; set; } = dimension;
    public int stream { get; set; } = stream;

    public static bool operator ==(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => lhs.Equals(rhs);
    public static bool operator !=(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => !lhs.Equals(rhs);

    public bool Equals(VertexAttributeDescriptor other) =>
        (attribute, format, dimension, stream) == (other.attribute, other.format, other.dimension, other.stream);

    public override bool Equals(object other) => other is VertexAttributeDescriptor descriptor && Equals(descriptor);
    public override int GetHashCode() => HashCode.Combine(attribute, format, dimension, stream);
    public override string ToString() => $"(attr={attribute} fmt={format} dim={dimension} stream={stream})";
}
