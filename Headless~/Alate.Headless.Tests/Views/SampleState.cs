using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Alate.Tests.Views;

/// <summary>A state of a playing sample as a page reads it, by the layout that the page's scene-format.js names.</summary>
internal sealed class SampleState
{
    private readonly byte[] m_Bytes;
    private int m_At = 16;

    public SampleState(byte[] bytes)
    {
        m_Bytes = bytes;
        Look = Whole();
        (Yaw, Pitch, Distance, Target) = (Number(), Number(), Number(), Vector());
        (Opening, Nearest, Behind) = (Number(), Number(), Vector());
        (Sky, Equator, Ground, SunFrom, Sun) = (Vector(), Vector(), Vector(), Vector(), Vector());
        HasShadows = Whole() == 1;
        for (uint left = Whole(); left > 0; left--)
            Lamps.Add((Vector(), Vector(), Number()));
        for (uint left = Whole(); left > 0; left--)
            Meshes.Add(ReadMesh());
        GoneMeshes = Take<uint>(Whole());
        for (uint left = Whole(); left > 0; left--)
        {
            (uint number, bool isNumbers, uint width, uint height) = (Whole(), Whole() == 1, Whole(), Whole());
            Maps.Add((number, (int)width, (int)height, isNumbers ? Take<float4>(width * height) : [],
                isNumbers ? [] : Take<byte>(4 * width * height)));
        }

        GoneMaps = Take<uint>(Whole());
        for (uint left = Whole(); left > 0; left--)
        {
            var draw = new Draw
            {
                Mesh = Whole(),
                Part = (int)Whole(),
                Picture = Whole(),
                Map = Whole(),
                Flags = Whole(),
                Through = Number(),
                Gloss = Number(),
                Shine = Number(),
                Underside = new float4(Number(), Number(), Number(), Number()),
            };
            draw.Instances = Take<Instance>(Whole());
            Draws.Add(draw);
        }

        Length = m_At;
    }

    public uint Magic => BitConverter.ToUInt32(m_Bytes, 0);

    public uint Sequence => BitConverter.ToUInt32(m_Bytes, 4);

    public double Time => BitConverter.ToDouble(m_Bytes, 8);

    public uint Look { get; }

    public float Yaw { get; }

    public float Pitch { get; }

    public float Distance { get; }

    public float3 Target { get; }

    public float Opening { get; }

    public float Nearest { get; }

    public float3 Behind { get; }

    public float3 Sky { get; }

    public float3 Equator { get; }

    public float3 Ground { get; }

    public float3 SunFrom { get; }

    public float3 Sun { get; }

    public bool HasShadows { get; }

    public List<(float3 Place, float3 Light, float Range)> Lamps { get; } = [];

    public List<Mesh> Meshes { get; } = [];

    public uint[] GoneMeshes { get; }

    public List<(uint Number, int Width, int Height, float4[] Numbers, byte[] Colours)> Maps { get; } = [];

    public uint[] GoneMaps { get; }

    public List<Draw> Draws { get; } = [];

    /// <summary>Bytes that were read.</summary>
    public int Length { get; }

    private Mesh ReadMesh()
    {
        var mesh = new Mesh { Number = Whole() };
        uint flags = Whole(), vertices = Whole(), parts = Whole();
        mesh.IsWhole = (flags & 1) != 0;
        mesh.Places = Take<float3>(vertices);
        sbyte[] normals = Take<sbyte>(4 * vertices);
        for (int v = 0; v < vertices; v++)
            mesh.Normals.Add(new float3(normals[4 * v], normals[4 * v + 1], normals[4 * v + 2]) / 127f);
        if (!mesh.IsWhole)
            return mesh;
        T[] Some<T>(uint flag) where T : struct => (flags & flag) != 0 ? Take<T>(vertices) : null;
        mesh.Coordinates = Some<float2>(2);
        mesh.Colours = Some<float4>(4);
        mesh.Baked = Some<float2>(8);
        mesh.Joints = Some<float4>(16);
        for (; parts > 0; parts--)
            mesh.Parts.Add(Take<int>(Whole()));
        return mesh;
    }

    private float Number() => Take<float>(1)[0];

    private uint Whole() => Take<uint>(1)[0];

    private float3 Vector() => Take<float3>(1)[0];

    private T[] Take<T>(uint count) where T : struct
    {
        T[] values = MemoryMarshal.Cast<byte, T>(m_Bytes.AsSpan(m_At))[..(int)count].ToArray();
        m_At += (int)count * Marshal.SizeOf<T>();
        return values;
    }

    /// <summary>A mesh that is new or has changed.</summary>
    internal sealed class Mesh
    {
        public uint Number { get; init; }

        public bool IsWhole { get; set; }

        public float3[] Places { get; set; }

        public List<float3> Normals { get; } = [];

        public float2[] Coordinates { get; set; }

        public float4[] Colours { get; set; }

        public float2[] Baked { get; set; }

        public float4[] Joints { get; set; }

        public List<int[]> Parts { get; } = [];
    }

    /// <summary>Instances of a part of a mesh.</summary>
    internal sealed class Draw
    {
        public uint Mesh { get; init; }

        public int Part { get; init; }

        public uint Picture { get; init; }

        public uint Map { get; init; }

        public uint Flags { get; init; }

        public float Through { get; init; }

        public float Gloss { get; init; }

        public float Shine { get; init; }

        public float4 Underside { get; init; }

        public Instance[] Instances { get; set; }
    }

    /// <summary>Rows of a matrix, a tint, and rows of loops or the first joint.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct Instance
    {
        public float4 x, y, z, tint, rows, next;

        public readonly float3 Place(float3 from) =>
            new(math.dot(x, new float4(from, 1f)), math.dot(y, new float4(from, 1f)), math.dot(z, new float4(from, 1f)));
    }
}
