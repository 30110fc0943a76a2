using System;

namespace UnityEngine;

/// <summary>Times that Time reads and the player loop advances.</summary>
internal static class Clock
{
    public static double Now { get; private set; }
    public static double UnscaledNow { get; private set; }
    public static double FixedTime { get; private set; }
    public static float DeltaTime { get; private set; }
    public static float UnscaledDeltaTime { get; private set; }
    public static int Frame { get; private set; }
    public static bool InFixedStep { get; set; }

    public static void Reset()
    {
        Now = UnscaledNow = FixedTime = 0.0;
        DeltaTime = UnscaledDeltaTime = 0f;
        Frame = 0;
        InFixedStep = false;
        Time.timeScale = 1f;
        Time.fixedDeltaTime = 0.02f;
        Time.maximumDeltaTime = 1f / 3f;
        Time.captureDeltaTime = 0f;
    }

    public static void BeginFrame(float frameTime)
    {
        Frame++;
        UnscaledDeltaTime = frameTime;
        UnscaledNow += frameTime;
        DeltaTime = Math.Min(frameTime, Time.maximumDeltaTime) * Time.timeScale;
        Now += DeltaTime;
    }

    /// <summary>Moves to the next fixed step if the frame's time has reached it. A hair of slack takes up what floats lose.</summary>
    public static bool NextFixedStep()
    {
        double next = FixedTime + Time.fixedDeltaTime;
        if (Time.timeScale == 0f || next > Now + 1e-9)
            return false;
        FixedTime = next;
        return true;
    }
}
