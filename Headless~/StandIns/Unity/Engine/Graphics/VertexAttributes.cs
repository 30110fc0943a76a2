using System;

namespace UnityEngine.Rendering;

public enum VertexAttribute
{
    Position = 0,
    Normal = 1,
    Tangent = 2,
    Color = 3,
    TexCoord0 = 4,
    TexCoord1 = 5,
    TexCoord2 = 6,
    TexCoord3 = 7,
    TexCoord4 = 8,
    TexCoord5 = 9,
    TexCoord6 = 10,
    TexCoord7 = 11,
    BlendWeight = 12,
    BlendIndices = 13,
}

public enum VertexAttributeFormat
{
    Float32 = 0,
    Float16 = 1,
    UNorm8 = 2,
    SNorm8 = 3,
    UNorm16 = 4,
    SNorm16 = 5,
    UInt8 = 6,
    SInt8 = 7,
    UInt16 = 8,
    SInt16 = 9,
    UInt32 = 10,
    SInt32 = 11,
}

[Flags]
public enum MeshUpdateFlags
{
    Default = 0,
    DontValidateIndices = 1,
    DontResetBoneBounds = 2,
    DontNotifyMeshUsers = 4,
    DontRecalculateBounds = 8,
}

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

    internal readonly int Size => dimension * format switch
    {
        VertexAttributeFormat.Float32 or VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32 => 4,
        VertexAttributeFormat.UNorm8 or VertexAttributeFormat.SNorm8 or VertexAttributeFormat.UInt8 or VertexAttributeFormat.SInt8 => 1,
        _ => 2,
    };

    public static bool operator ==(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => lhs.Equals(rhs);
    public static bool operator !=(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => !lhs.Equals(rhs);

    public bool Equals(VertexAttributeDescriptor other) =>
        attribute == other.attribute && format == other.format && dimension == other.dimension && stream == other.stream;

    public override bool Equals(object other) => other is VertexAttributeDescriptor d && Equals(d);
    public override int GetHashCode() => HashCode.Combine(attribute, format, dimension, stream);
    public override string ToString() => $"(attr={attribute} fmt={format} dim={dimension} stream={stream})";
}

public struct SubMeshDescriptor(int indexStart, int indexCount, MeshTopology topology = MeshTopology.Triangles)
{
    public Bounds bounds { get; set; }
    public MeshTopology topology { get; set; } = topology;
    public int indexStart { get; set; } = indexStart;
    public int indexCount { get; set; } = indexCount;
    public int baseVertex { get; set; }
    public int firstVertex { get; set; }
    public int vertexCount { get; set; }
}
