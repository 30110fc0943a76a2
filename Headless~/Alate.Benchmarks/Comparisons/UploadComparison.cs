using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Collections;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>
/// Bytes that the main thread writes into the meshes of 400 monarchs, and the cost of their skinning: normals and tangents as signed bytes
/// against floats, as version 0.1 had them, and joints for the graphics card against signed bytes. Setting a mesh's data is a stand-in that
/// copies; Unity copies as well, and hands the bytes to the graphics card.
/// </summary>
internal static class UploadComparison
{
    private const int k_Insects = 400;

    public static void Run(Report report, Specimen monarch)
    {
        SurfaceMesh surface = monarch.Wing.CreateSurface(WingSide.Right);
        Compare(report, monarch, surface, false);
        surface.tangents = Array.ConvertAll(surface.positions, _ => new Vector4(1f, 0f, 0f, -1f));
        Compare(report, monarch, surface, true);
    }

    private static void Compare(Report report, Specimen monarch, SurfaceMesh surface, bool tangents)
    {
        var mesh = surface.ToMesh("monarch");
        var rig = WingRig.Bake(monarch.Skeleton, surface, WingRigSettings.Default);
        using var floats = new Uploaded(mesh, rig, monarch, VertexPacking.None);
        using var packed = new Uploaded(mesh, rig, monarch, tangents ? VertexPacking.NormalsAndTangents : VertexPacking.Normals);
        using var unread = new Uploaded(mesh, rig, monarch, VertexPacking.Normals);
        using var joints = new Uploaded(mesh, rig, monarch, VertexPacking.Joints);
        rig.Release();
        double[] upload = Race.Run(packed.Upload, floats.Upload, unread.Upload, joints.Upload);
        double[] skin = Race.Run(packed.Skin, floats.Skin, joints.Skin);
        string group = tangents ? "with tangents" : "no tangents";
        report.Ratio(Targets.Upload, group, upload[0], upload[1], upload[0] / upload[1]);
        report.Ratio(Targets.PackedSkin, group, skin[0], skin[1], skin[0] / skin[1]);
        report.Ratio(Targets.GpuUpload, group, upload[3], upload[0], upload[3] / upload[0]);
        report.Ratio(Targets.GpuSkin, group, skin[2], skin[0], skin[2] / skin[0]);
        report.Figure("upload_bytes_a_vertex", group, $"{group}: bytes a vertex", "bytes", packed.BytesAVertex);
        if (tangents)
            report.Ratio(Targets.Upload, "tangents unread", upload[2], upload[1], upload[2] / upload[1]);
        UnityEngine.Object.DestroyImmediate(mesh);
    }

    /// <summary>A world of wings and a mesh for each.</summary>
    private sealed class Uploaded : IDisposable
    {
        private readonly WingWorld m_World = new();
        private readonly List<(WingHandle wing, Mesh mesh)> m_Wings = [];
        private readonly bool m_Packed, m_HasJoints;
        private readonly SkinTable m_Table = new(SystemInfo.maxTextureSize);
        private readonly List<int> m_Starts = [];

        public Uploaded(Mesh source, WingRig rig, Specimen kind, VertexPacking packing)
        {
            m_Packed = packing != VertexPacking.None;
            m_HasJoints = packing == VertexPacking.Joints;
            int[] order = [.. Enumerable.Range(0, source.vertexCount)];
            for (int wing = 0; wing < 2 * k_Insects; wing++)
            {
                m_Wings.Add((m_World.Add(rig, kind.Parameters, kind.FlightOf(wing), default, packing), DeformableMesh.Build(
                    source, order, m_Packed, moves: false)));
                if (m_HasJoints && m_Table.TryTake(rig.JointCount, false, out int start))
                    m_Starts.Add(start);
            }

            m_World.JointMemory = m_Table;
            for (int k = 0; k < m_Starts.Count; k++)
                m_World.PlaceJoints(m_Wings[k].wing, m_Starts[k]);
            m_World.Step(0.02f);
            m_World.Skin();
        }

        public Contestant Upload => new("upload", 1000.0, UploadAll);

        public Contestant Skin => new("skin", 1000.0, () => m_World.Skin());

        public int BytesAVertex => m_Wings[0].mesh.GetVertexBufferStride(DeformableMesh.VertexStream)
            + (m_World.PackedTangents(m_Wings[0].wing).IsCreated ? m_Wings[0].mesh.GetVertexBufferStride(DeformableMesh.TangentStream) : 0);

        public void Dispose()
        {
            foreach ((_, Mesh mesh) in m_Wings)
                UnityEngine.Object.DestroyImmediate(mesh);
            m_World.Dispose();
            m_Table.Dispose();
        }

        private void UploadAll()
        {
            if (m_HasJoints)
            {
                UploadJoints();
                return;
            }

            foreach ((WingHandle wing, Mesh mesh) in m_Wings)
            {
                if (m_Packed)
                {
                    Set(mesh, m_World.PackedVertices(wing), DeformableMesh.VertexStream);
                    Set(mesh, m_World.PackedTangents(wing), DeformableMesh.TangentStream);
                }
                else
                {
                    Set(mesh, m_World.Vertices(wing), DeformableMesh.VertexStream);
                    Set(mesh, m_World.Tangents(wing), DeformableMesh.TangentStream);
                }
            }
        }

        private void UploadJoints()
        {
            m_Table.Begin();
            m_Table.MarkWritten();
            m_Table.End();
        }

        private static void Set<T>(Mesh mesh, NativeArray<T> values, int stream) where T : struct
        {
            if (values.IsCreated)
                mesh.SetVertexBufferData(values, 0, 0, values.Length, stream, DeformableMesh.UploadFlags);
        }
    }
}
