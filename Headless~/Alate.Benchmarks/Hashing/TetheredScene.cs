using System.Linq;
using Alate.Catalogue;

namespace Alate.Benchmarks;

/// <summary>
/// Wings of all insects of the catalogue beat on the spot in air of four speeds; in the middle of the time a gust comes from the side.
/// </summary>
internal static class TetheredScene
{
    private const int k_Frames = 20, k_Speeds = 4;
    private const float k_FrameTime = 1f / 60f;

    /// <summary>Speed from one to the next as a share of the first, and the gust as a share of the wind.</summary>
    private const float k_Faster = 0.45f, k_Gust = 0.8f;

    /// <summary>Runs the scene.</summary>
    public static ulong Run(HashVariant variant)
    {
        var kinds = InsectCatalogue.All.SelectMany(insect => insect.Wings).Select(wing => new Specimen(wing)).ToList();
        using var world = new WingWorld();
        foreach (Specimen kind in kinds)
        {
            for (int k = 0; k < variant.Shift; k++)
                world.Add(kind.Rig, kind.Parameters, Air(kind, k + 7f));
        }

        var wings = new WingHandle[kinds.Count * k_Speeds];
        foreach (int number in variant.OrderOf(wings.Length))
        {
            Specimen kind = kinds[number / k_Speeds];
            wings[number] = world.Add(kind.Rig, kind.Parameters, Air(kind, number % k_Speeds));
        }

        BitHash hash = BitHash.Empty;
        for (int frame = 0; frame < k_Frames; frame++)
        {
            for (int number = 0; frame == k_Frames / 2 && number < wings.Length; number++)
            {
                WingSurroundings air = Air(kinds[number / k_Speeds], number % k_Speeds);
                air.wind.x = -k_Gust * air.wind.z;
                world.SetSurroundings(wings[number], air);
            }

            world.Step(k_FrameTime);
            foreach (WingHandle wing in wings)
                hash.Add(world.Read(wing));
        }

        kinds.ForEach(kind => kind.Dispose());
        return hash.Value;
    }

    private static WingSurroundings Air(Specimen kind, float number)
    {
        WingSurroundings air = kind.Flight;
        float factor = 0.3f + k_Faster * number;
        air.wind *= factor;
        air.speed *= factor;
        return air;
    }
}
