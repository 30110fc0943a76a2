namespace Alate.Benchmarks;

/// <summary>A figure of the report and what it should be.</summary>
/// <param name="Key">Its name in the JSON.</param>
/// <param name="Title">Its name in the table: baseline / ours, or ours / limit.</param>
/// <param name="Unit">Unit of the times.</param>
/// <param name="Must">The value that must be reached.</param>
/// <param name="Aim">The value to strive for.</param>
internal sealed record Target(string Key, string Title, string Unit, double Must, double Aim)
{
    /// <summary>True where larger is better, as for a baseline divided by ours.</summary>
    public bool LargerIsBetter => Aim > Must;

    public string Verdict(double value) => Reaches(value, Aim) ? "aim" : Reaches(value, Must) ? "must" : "MISSED";

    private bool Reaches(double value, double target) => LargerIsBetter ? value >= target : value <= target;
}

/// <summary>All figures with a target, most of them ratios, and their targets on a machine like the one they were set on.</summary>
internal static class Targets
{
    public static readonly Target NaiveDqs = new("naive_dqs_over_grouped", "naive DQS / grouped DQS", "ns/vertex", 5, 8);

    // At least 2 on any machine: what the compiler makes of the naive one differs more between machines than ours.
    public static readonly Target NaiveLbs = new("naive_lbs_over_grouped", "naive LBS / grouped DQS", "ns/vertex", 2.0, 4);
    public static readonly Target Calibration = new("grouped_over_fma", "grouped DQS / multiply-adds alone", "ns/vertex", 1.5, 1.3);
    public static readonly Target Triangle = new("naive_triangle_over_patch", "naive triangle / patch", "ns/element", 4, 6.5);
    public static readonly Target Cholesky = new("cholesky_over_pcg", "dense Newton / block Newton", "us/iteration", 25, 50);
    public static readonly Target Motion = new("scalar_fk_over_lanes", "scalar FK / lane FK", "ns/joint", 2.5, 4);
    public static readonly Target Frame = new("naive_frame_over_frame", "naive frame / frame of 64 monarchs", "us/insect", 12, 25);
    public static readonly Target EarlierFrame = new(
        "naive_frame_over_frame_01", "naive frame / frame of version 0.1", "us/insect", 12, 25);
    public static readonly Target FrameShare = new("frame_over_frame_01", "frame / frame of version 0.1", "us/insect", 0.6, 0.5);
    public static readonly Target BeatShare = new("beat_over_beat_01", "beat / beat of version 0.1", "us/insect", 0.75, 0.6);
    public static readonly Target Indexer = new("indexer_over_pointer", "NativeArray indexer / pointer", "ns/element", 1.2, 1.0);
    public static readonly Target Crowd = new("crowd_400_over_16", "an insect of 400 / of 16", "us/insect", 1.3, 1.1);
    public static readonly Target Cores = new("two_cores_over_one", "two cores / one, 64 insects", "us/insect", 1.7, 1.9);
    public static readonly Target Flight = new(
        "flight_over_wings", "frame of 400 monarchs that fly / of their wings", "us/insect", 1.1, 1.05);
    public static readonly Target FlightByReaction = new(
        "flight_by_reaction_over_wings", "frame of 400 monarchs with all terms / of their wings", "us/insect", 1.15, 1.1);
    public static readonly Target Inflow = new(
        "inflow_over_beat", "beat of 64 monarchs with a replayed wake / without", "us/insect", 1.02, 1.01);
    public static readonly Target Trace = new("trace_2000_ms", "tracing a picture of 2000 x 2000", "ms", 2000, 1000);
    public static readonly Target Upload = new("upload_over_floats", "upload / upload of floats, 400 insects", "us/frame", 0.8, 0.67);
    public static readonly Target PackedSkin = new(
        "packed_skin_over_floats", "skinning / skinning into floats, 400 insects", "us/frame", 1.1, 1.0);
    public static readonly Target GpuFrame = new(
        "living_gpu_over_cpu", "a frame of living monarchs by the graphics card / by the processor", "us/insect", 0.8, 0.65);
    public static readonly Target GpuMain = new(
        "living_gpu_main_over_cpu", "main thread by the graphics card / by the processor", "us/frame", 0.5, 0.4);
    public static readonly Target SmallerMeshes = new(
        "living_smaller_over_whole", "a frame with smaller meshes in the distance / with whole ones", "us/insect", 0.95, 0.8);
    public static readonly Target Start = new(
        "start_1000_gpu_ms", "start of 1000 monarchs by the graphics card, longest frame", "ms", 5, 3);
    public static readonly Target GpuUpload = new(
        "joints_upload_over_packed", "joints for the graphics card / upload, 400 insects", "us/frame", 0.4, 0.2);
    public static readonly Target GpuSkin = new(
        "joints_skin_over_packed", "joints for the graphics card / skinning, 400 insects", "us/frame", 0.4, 0.2);
    public static readonly Target Vortices = new("plain_vortices_over_wake", "plain / vortex segments", "ns/influence", 4, 6);
    public static readonly Target WakeCores = new("wake_two_cores_over_one", "wake on two cores / one", "s", 1.7, 1.9);
    public static readonly Target Single = new("single_insect_over_crowd", "an insect alone / of 64", "us/insect", 2.0, 2.0);
}
