namespace Alate.Benchmarks;

/// <summary>A way to draw a crowd of monarchs.</summary>
internal enum LivingCrowd
{
    /// <summary>Live in full detail, deformed by the processor.</summary>
    Cpu,

    /// <summary>Live in full detail, deformed by the graphics card.</summary>
    Gpu,

    /// <summary>At many distances, three of ten near, with the levels of detail of their sizes, deformed by the processor.</summary>
    CpuWithLevels,

    /// <summary>The same, deformed by the graphics card.</summary>
    GpuWithLevels,

    /// <summary>The same with a budget.</summary>
    GpuWithBudget,

    /// <summary>Baked.</summary>
    Baked,
}

/// <summary>Time of a frame of a crowd.</summary>
/// <param name="Crowd">How it is drawn.</param>
/// <param name="Insects">How many.</param>
/// <param name="Frame">Milliseconds on all cores, jobs included.</param>
/// <param name="Main">Milliseconds of the main thread, without its waiting.</param>
internal sealed record LivingFrame(LivingCrowd Crowd, int Insects, double Frame, double Main);
