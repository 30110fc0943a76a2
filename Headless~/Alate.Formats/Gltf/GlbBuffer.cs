using System.Text.Json.Nodes;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Formats;

/// <summary>The binary part of a GLB file and the accessors into it. Every accessor has a view of its own, aligned to four bytes.</summary>
internal sealed class GlbBuffer
{
    private const int k_UnsignedShort = 5123, k_UnsignedInt = 5125, k_Float = 5126;
    private const int k_ArrayBuffer = 34962, k_ElementArrayBuffer = 34963;

    private readonly MemoryStream m_Bytes = new();
    private readonly BinaryWriter m_Writer;

    public GlbBuffer()
    {
        m_Writer = new BinaryWriter(m_Bytes);
    }

    public JsonArray Views { get; } = [];

    public JsonArray Accessors { get; } = [];

    public byte[] ToArray() => m_Bytes.ToArray();

    /// <summary>Vertex attributes or values of an animation, with their bounds.</summary>
    public int AddVectors(IReadOnlyList<float3> values, bool isVertexData = true)
    {
        int view = BeginView(isVertexData ? k_ArrayBuffer : null);
        float3 min = float.PositiveInfinity, max = float.NegativeInfinity;
        foreach (float3 value in values)
        {
            m_Writer.Write(value.x);
            m_Writer.Write(value.y);
            m_Writer.Write(value.z);
            min = math.min(min, value);
            max = math.max(max, value);
        }

        JsonObject accessor = EndView(view, k_Float, "VEC3", values.Count);
        accessor["min"] = new JsonArray(min.x, min.y, min.z);
        accessor["max"] = new JsonArray(max.x, max.y, max.z);
        return Add(accessor);
    }

    /// <summary>Rotations of an animation, or weights of joints.</summary>
    public int AddQuadruples(IReadOnlyList<float4> values, bool isVertexData = false)
    {
        int view = BeginView(isVertexData ? k_ArrayBuffer : null);
        foreach (float4 value in values)
        {
            for (int k = 0; k < 4; k++)
                m_Writer.Write(value[k]);
        }

        return Add(EndView(view, k_Float, "VEC4", values.Count));
    }

    /// <summary>Texture coordinates, from the upper left.</summary>
    public int AddPairs(IReadOnlyList<float2> values)
    {
        int view = BeginView(k_ArrayBuffer);
        foreach (float2 value in values)
        {
            m_Writer.Write(value.x);
            m_Writer.Write(value.y);
        }

        return Add(EndView(view, k_Float, "VEC2", values.Count));
    }

    /// <summary>Vertex colours: linear, as glTF has them, in 16 bits so that dark ones keep their steps.</summary>
    public int AddColours(IReadOnlyList<Color32> colours)
    {
        int view = BeginView(k_ArrayBuffer);
        foreach (Color32 colour in colours)
        {
            m_Writer.Write(Linear(colour.r));
            m_Writer.Write(Linear(colour.g));
            m_Writer.Write(Linear(colour.b));
            m_Writer.Write((ushort)(257 * colour.a));
        }

        JsonObject accessor = EndView(view, k_UnsignedShort, "VEC4", colours.Count);
        accessor["normalized"] = true;
        return Add(accessor);
    }

    /// <summary>Joints that move a vertex, in 16 bits.</summary>
    public int AddJoints(IReadOnlyList<int4> values)
    {
        int view = BeginView(k_ArrayBuffer);
        foreach (int4 value in values)
        {
            for (int c = 0; c < 4; c++)
                m_Writer.Write((ushort)value[c]);
        }

        return Add(EndView(view, k_UnsignedShort, "VEC4", values.Count));
    }

    /// <summary>Matrices that only move.</summary>
    public int AddTranslations(IReadOnlyList<float3> values)
    {
        int view = BeginView(null);
        foreach (float3 value in values)
        {
            float[] columns = [1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f, 0f, value.x, value.y, value.z, 1f];
            foreach (float entry in columns)
                m_Writer.Write(entry);
        }

        return Add(EndView(view, k_Float, "MAT4", values.Count));
    }

    /// <summary>Corners of triangles; 16 bits where they suffice.</summary>
    public int AddIndices(IReadOnlyList<int> indices, int vertexCount)
    {
        // The largest value of either size is reserved.
        bool small = vertexCount <= ushort.MaxValue;
        int view = BeginView(k_ElementArrayBuffer);
        foreach (int index in indices)
        {
            if (small)
                m_Writer.Write((ushort)index);
            else
                m_Writer.Write((uint)index);
        }

        return Add(EndView(view, small ? k_UnsignedShort : k_UnsignedInt, "SCALAR", indices.Count));
    }

    /// <summary>Times or values of an animation, with their bounds.</summary>
    public int AddScalars(IReadOnlyList<float> values)
    {
        int view = BeginView(null);
        float min = float.PositiveInfinity, max = float.NegativeInfinity;
        foreach (float value in values)
        {
            m_Writer.Write(value);
            min = math.min(min, value);
            max = math.max(max, value);
        }

        JsonObject accessor = EndView(view, k_Float, "SCALAR", values.Count);
        accessor["min"] = new JsonArray(min);
        accessor["max"] = new JsonArray(max);
        return Add(accessor);
    }

    /// <summary>A file within the file, such as a picture.</summary>
    /// <returns>Its view.</returns>
    public int AddFile(byte[] content)
    {
        int view = BeginView(null);
        m_Writer.Write(content);
        EndView(view, 0, "", 0);
        return view;
    }

    private int BeginView(int? target)
    {
        var view = new JsonObject { ["buffer"] = 0, ["byteOffset"] = m_Bytes.Position };
        if (target != null)
            view["target"] = target;
        Views.Add(view);
        return Views.Count - 1;
    }

    private JsonObject EndView(int view, int componentType, string type, int count)
    {
        var json = (JsonObject)Views[view];
        json["byteLength"] = m_Bytes.Position - (long)json["byteOffset"];
        while (m_Bytes.Position % 4 != 0)
            m_Writer.Write((byte)0);
        return new JsonObject { ["bufferView"] = view, ["componentType"] = componentType, ["count"] = count, ["type"] = type };
    }

    private int Add(JsonObject accessor)
    {
        Accessors.Add(accessor);
        return Accessors.Count - 1;
    }

    private static ushort Linear(byte value) => (ushort)Math.Round(65535.0 * FileColours.Linear(value));
}
