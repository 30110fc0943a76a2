using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Unity.Jobs.LowLevel.Unsafe;

namespace Alate.Benchmarks;

/// <summary>
/// Scenes whose results are equal to the last bit whatever the number of threads, the order of creation, the lanes of the wings and the
/// processor, and the hashes that they had when the model was last changed.
/// </summary>
public static class SceneHashes
{
    private const int k_FreeFrames = 60, k_WanderFrames = 90, k_CrowdFrames = 20, k_EachInCrowd = 4;

    private static readonly string[] s_Flyers =
        ["monarch", "swallowtail", "painted-lichen-moth", "fishfly", "firefly", "dragonfly", "snailfish"];

    /// <summary>
    /// Scenes by name, and their hashes: a change of the physics by intent changes them, and <c>bench --hash</c> prints those to put here.
    /// </summary>
    private static readonly (string Name, ulong Held, Func<HashVariant, ulong> Run)[] s_Scenes =
    [
        ("tethered", 0x183b0f6e62fdddc4, TetheredScene.Run),
        ("free", 0x5a41d285488d016c, variant => FleetScene.Run(s_Flyers, false, k_FreeFrames, false, variant)),
        ("wander", 0x27a60c49ae3a0b0a, variant => FleetScene.Run(s_Flyers, true, k_WanderFrames, false, variant)),
        ("crowd", 0x4e8be3b7211b329a, variant => FleetScene.Run(Crowd(), true, k_CrowdFrames, true, variant)),
    ];

    /// <summary>Names of the scenes.</summary>
    public static IReadOnlyList<string> Names { get; } = Array.ConvertAll(s_Scenes, scene => scene.Name);

    /// <summary>Runs each scene in several ways, prints its hash, and tells where it is not the held one.</summary>
    /// <param name="output">Takes a line a scene.</param>
    /// <param name="scene">Name of the only one to run; null runs all.</param>
    /// <returns>0; 1 where a scene has another hash than the held one, or not always the same.</returns>
    public static int Run(TextWriter output, string scene = null)
    {
        int workers = JobsUtility.JobWorkerCount;
        bool equal = true;
        try
        {
            foreach ((string name, ulong held, Func<HashVariant, ulong> run) in s_Scenes)
                equal &= (scene != null && scene != name) || Compare(name, held, run, output);
        }
        finally
        {
            JobsUtility.JobWorkerCount = workers;
        }

        return equal ? 0 : 1;
    }

    private static bool Compare(string name, ulong held, Func<HashVariant, ulong> run, TextWriter output)
    {
        var hashes = new List<ulong>();
        foreach (HashVariant variant in HashVariant.All)
        {
            JobsUtility.JobWorkerCount = Math.Min(variant.Workers, JobsUtility.JobWorkerMaximumCount);
            hashes.Add(run(variant));
        }

        output.WriteLine($"{name,-10} 0x{hashes[0]:x16}{(hashes[0] == held ? "" : $"  differs from the held 0x{held:x16}")}");
        for (int k = 1; k < hashes.Count; k++)
        {
            if (hashes[k] != hashes[0])
                output.WriteLine($"{"",-10} 0x{hashes[k]:x16}  with {HashVariant.All[k]}");
        }

        return hashes.All(hash => hash == held);
    }

    private static string[] Crowd() => Enumerable.Repeat(s_Flyers, k_EachInCrowd).SelectMany(flyers => flyers).ToArray();
}
