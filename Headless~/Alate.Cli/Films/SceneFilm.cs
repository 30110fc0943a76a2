using UnityEngine;

namespace Alate.Cli;

/// <summary>Plays a sample scene and paints its frames.</summary>
internal static class SceneFilm
{
    /// <summary>Share of a frame's time in which the shutter is open.</summary>
    private const double k_Shutter = 0.5;

    /// <summary>[encoded value] Linear light.</summary>
    private static readonly float[] s_Light =
        [.. Enumerable.Range(0, byte.MaxValue + 1).Select(value => Shading.ToLinear(value / (float)byte.MaxValue).x)];

    /// <summary>Plays and paints every frame, rows from above.</summary>
    /// <param name="plan">What is filmed.</param>
    /// <param name="done">Told the frames done.</param>
    /// <exception cref="UserException">The panel of the sample has no such slider or button.</exception>
    public static Color32[][] Play(SceneFilmPlan plan, Action<int> done)
    {
        using var sample = new PlayedSample(plan.Scene);
        foreach (string setting in plan.Settings)
            sample.Set(setting);
        Look(sample, plan);
        sample.Step(plan.After);
        var frames = new Color32[plan.Count][];

        // The scene plays on one thread, its pictures are painted on all: a few at a time, as their meshes take memory.
        int batch = Environment.ProcessorCount;
        for (int first = 0; first < frames.Length; first += batch)
        {
            var shots = new List<List<SceneShot>>();
            for (int k = first; k < Math.Min(first + batch, frames.Length); k++)
                shots.Add(Expose(sample, plan));
            Color32[][] painted = Concurrently.Map(
                shots, SampleGrid.BytesOf(plan.Size), frame => Mean(frame.ConvertAll(shot => shot.Paint())));
            painted.CopyTo(frames, first);
            done(first + painted.Length);
        }

        return frames;
    }

    private static void Look(PlayedSample sample, SceneFilmPlan plan)
    {
        if (plan.Look is not [double yaw, double pitch, double distance, .. double[] target])
            return;
        sample.Orbit.Yaw = (float)yaw;
        sample.Orbit.Pitch = (float)pitch;
        sample.Orbit.Distance = (float)distance;
        if (target is [double x, double y, double z])
            sample.Orbit.Target = new Vector3((float)x, (float)y, (float)z);
    }

    private static List<SceneShot> Expose(PlayedSample sample, SceneFilmPlan plan)
    {
        double frame = 1.0 / plan.Rate, open = plan.Exposures > 1 ? k_Shutter * frame / plan.Exposures : 0.0;
        var shots = new List<SceneShot>();
        for (int k = 0; k < plan.Exposures; k++)
        {
            sample.Step(k == 0 ? frame - (plan.Exposures - 1) * open : open);
            sample.Orbit.Yaw += (float)(plan.Turn / plan.Count / plan.Exposures);
            shots.Add(sample.Shot(plan.Size));
        }

        return shots;
    }

    // Of light, not of encoded values.
    private static Color32[] Mean(List<Color32[]> pictures)
    {
        if (pictures.Count == 1)
            return pictures[0];
        var mean = new Color32[pictures[0].Length];
        for (int k = 0; k < mean.Length; k++)
        {
            float3 light = 0f;
            foreach (Color32[] picture in pictures)
                light += new float3(s_Light[picture[k].r], s_Light[picture[k].g], s_Light[picture[k].b]);
            var shown = (int3)math.round(255f * Shading.ToEncoded(light / pictures.Count));
            mean[k] = new Color32((byte)shown.x, (byte)shown.y, (byte)shown.z, byte.MaxValue);
        }

        return mean;
    }
}
