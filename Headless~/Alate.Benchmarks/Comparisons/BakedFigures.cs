using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Crowds;
using Unity.Collections;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Benchmarks;

/// <summary>
/// Cost of a crowd of baked monarchs a frame, its jobs on the calling thread included, before one camera and two, its allocations, and the
/// size of its meshes. Drawing itself is a stand-in.
/// </summary>
internal static class BakedFigures
{
    private const int k_Frames = 20;
    private const float k_FrameTime = 1f / 60f;

    private static readonly int[] s_Crowds = [1, 100, 1000, 10000];

    /// <summary>Measures all crowds.</summary>
    public static List<LivingFrame> Run(Report report)
    {
        PlayerLoop.EnterPlayMode();
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
        InsectWings insect = InsectFactory.Create("monarch");
        InsectBake bake = InsectBaker.Bake(insect, [BakeMotion.Find("cruise"), BakeMotion.Find("rest")], BakeSettings.Default);
        var baked = BakedInsect.Create(bake);
        insect.gameObject.SetActive(false);
        Camera eye = new GameObject("eye").AddComponent<Camera>();
        eye.transform.position = new Vector3(0f, 0f, -60f);
        report.Figure("baked_texture_kb", "texture of two loops", "kB", baked.TextureBytes / 1024.0);
        foreach (CrowdSize size in baked.Sizes)
        {
            report.Figure(
                "baked_size_error_percent", $"{size.triangles}", $"mesh of {size.triangles} triangles", "% of wing", 100.0 * size.error);
        }
        Camera other = new GameObject("other").AddComponent<Camera>();
        other.transform.position = new Vector3(60f, 0f, 0f);
        other.transform.rotation = Quaternion.Euler(0f, -90f, 0f);
        var frames = new List<LivingFrame>();
        foreach (int count in s_Crowds)
            frames.Add(Measure(report, baked, eye, other, count));
        baked.DestroyParts();
        Object.DestroyImmediate(baked);
        ProjectShaders.Clear();
        PlayerLoop.ExitPlayMode();
        return frames;
    }

    private static LivingFrame Measure(Report report, BakedInsect baked, Camera eye, Camera other, int count)
    {
        InsectCrowd crowd = new GameObject("crowd").AddComponent<InsectCrowd>();
        crowd.Insect = baked;
        crowd.Count = count;
        crowd.Camera = eye;
        NativeArray<CrowdPose> poses = crowd.Poses;
        for (int k = 0; k < count; k++)
            poses[k] = CrowdPose.At(new float3(k % 100 - 50f, k / 100 % 10 - 5f, k / 1000), quaternion.RotateY(k), k / (float)count);
        double[] times = Race.Run(
            new Contestant($"{count} for a camera", 1000.0, () => Frame(eye)),
            new Contestant($"{count} for two", 1000.0, () => Frame(eye, other)),
            new Contestant($"{count} drawn", 1000.0, () => crowd.RunCamera(eye)));
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int k = 0; k < k_Frames; k++)
            Frame(eye);
        long garbage = GC.GetAllocatedBytesForCurrentThread() - before;
        other.enabled = false;
        PlayerLoop.Tick(k_FrameTime);
        other.enabled = true;

        string title = $"frame of {count} baked insects for one camera, {crowd.DrawnCount} in sight";
        report.Figure("baked_frame_us", $"{count}", title, "us", times[0]);
        report.Figure("baked_camera_us", $"{count}", "  of which the camera, on the main thread", "us", times[2]);
        report.Figure("baked_two_cameras", $"{count}", "  with a second camera", "times as long", times[1] / times[0]);
        report.Figure("baked_bytes_per_frame", $"{count}", "  allocated", "bytes", garbage / (double)k_Frames);
        report.Figure("baked_draw_calls", $"{count}", "  drawn by", "calls", crowd.DrawCalls);
        report.Figure("baked_triangles", $"{count}", "  triangles", "thousands", crowd.Triangles / 1000.0);
        Object.DestroyImmediate(crowd.gameObject);
        return new LivingFrame(LivingCrowd.Baked, count, 1e-3 * times[0], 1e-3 * times[2]);

        void Frame(params ReadOnlySpan<Camera> cameras)
        {
            crowd.RunFrame(k_FrameTime);
            foreach (Camera camera in cameras)
                crowd.RunCamera(camera);
        }
    }
}
