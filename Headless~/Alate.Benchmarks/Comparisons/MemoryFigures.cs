using System;
using System.Collections.Generic;
using System.Linq;
using StandIns;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>Memory of one living insect.</summary>
/// <param name="Crowd">How it is drawn.</param>
/// <param name="Part">What the memory is for.</param>
/// <param name="Bytes">Bytes, what insects share left out.</param>
internal sealed record InsectMemory(LivingCrowd Crowd, string Part, double Bytes);

/// <summary>
/// Counts the memory of living monarchs by part: what many take beyond what few take, over the number of insects between them. Meshes are
/// counted as the processor keeps them; the graphics card has them as well. Objects are those of the managed heap, where the stand-ins for
/// Unity's own lie too.
/// </summary>
internal static class MemoryFigures
{
    /// <summary>Number of insects.</summary>
    public const int Insects = 400;

    /// <summary>Parts of an insect, and all of them together.</summary>
    public const string State = "state of the wings", Vertices = "vertices that the jobs write", Joints = "joints",
        Lists = "lists of the jobs", Meshes = "meshes", Objects = "objects", All = "all";

    // So many that what is laid out in steps, for four wings or for the next power of two, evens out.
    private const int k_Few = 16, k_WarmUp = 8;
    private const float k_FrameTime = 1f / 60f;

    private static readonly Dictionary<string, string> s_Parts = new()
    {
        ["UnsafeUtility.MallocTracked"] = State,
        ["NativeArray<PackedVertex>"] = Vertices,
        ["NativeArray<SkinnedVertex>"] = Vertices,
        ["NativeArray<DualQuaternion>"] = Joints,

        // Pixels of the texture that holds them.
        ["NativeArray<Color>"] = Joints,
    };

    /// <summary>Ways to draw that are measured.</summary>
    public static IReadOnlyList<LivingCrowd> Crowds { get; } = [LivingCrowd.Cpu, LivingCrowd.Gpu];

    /// <summary>Names of the parts, the sum last.</summary>
    public static IReadOnlyList<string> Parts { get; } = [State, Vertices, Joints, Lists, Meshes, Objects, All];

    /// <summary>Measures all.</summary>
    public static List<InsectMemory> Run(Report report)
    {
        var all = new List<InsectMemory>();
        foreach (LivingCrowd crowd in Crowds)
        {
            // What a process did before is let go in the first round.
            Count(crowd, k_Few);
            Dictionary<string, long> few = Count(crowd, k_Few), many = Count(crowd, Insects);
            var parts = Parts.SkipLast(1)
                .Select(part => new InsectMemory(crowd, part, (many[part] - few[part]) / (double)(Insects - k_Few))).ToList();
            parts.Add(new InsectMemory(crowd, All, parts.Sum(part => part.Bytes)));
            foreach (InsectMemory part in parts)
            {
                report.Figure(
                    $"memory_{crowd}_kb".ToLowerInvariant(), part.Part, $"a monarch, {crowd}: {part.Part}", "kB", part.Bytes / 1e3);
            }

            all.AddRange(parts);
        }

        return all;
    }

    private static Dictionary<string, long> Count(LivingCrowd crowd, int insects)
    {
        PlayerLoop.EnterPlayMode();
        var monarch = new Brood(crowd == LivingCrowd.Cpu ? WingSkinning.Cpu : WingSkinning.Gpu);
        long before = GC.GetTotalMemory(true);
        IReadOnlyDictionary<string, long> native = NativeMemoryLedger.BytesBySource();
        for (int k = 0; k < insects; k++)
            monarch.Hatch(k, Vector3.forward);
        for (int frame = 0; frame < k_WarmUp || WingSystem.InsectCount < insects; frame++)
            PlayerLoop.Tick(k_FrameTime);
        var bytes = Parts.ToDictionary(part => part, _ => 0L);
        foreach ((string source, long size) in NativeMemoryLedger.BytesBySource())
            bytes[s_Parts.GetValueOrDefault(source, Lists)] += size - native.GetValueOrDefault(source);
        // The smaller triangles are the last of the index buffer.
        LivingFigures.Show(smaller: true);
        Mesh[] shown = [.. UnityEngine.Object.FindObjectsByType<MeshFilter>(FindObjectsSortMode.None)
            .Select(filter => filter.sharedMesh).Distinct()];
        bytes[Meshes] = shown.Sum(mesh => Size(mesh, sizeof(ushort)));
        // The stand-ins keep indices as whole numbers of four bytes.
        bytes[Objects] = GC.GetTotalMemory(true) - before - shown.Sum(mesh => Size(mesh, sizeof(int)));
        PlayerLoop.ExitPlayMode();
        return bytes;
    }

    private static long Size(Mesh mesh, int index)
    {
        long indices = Enumerable.Range(0, mesh.subMeshCount).Max(part => (long)mesh.GetIndexStart(part) + mesh.GetIndexCount(part));
        int stride = Enumerable.Range(0, mesh.vertexBufferCount).Sum(mesh.GetVertexBufferStride);
        return index * indices + (long)mesh.vertexCount * stride;
    }
}
