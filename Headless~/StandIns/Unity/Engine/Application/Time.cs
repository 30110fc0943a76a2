using System;

namespace UnityEngine;

/// <summary>The player loop's clock. Inside FixedUpdate, time and deltaTime are those of the fixed step.</summary>
public class Time
{
    private static float s_TimeScale = 1f;
    private static float s_FixedDeltaTime = 0.02f;
    private static float s_MaximumDeltaTime = 1f / 3f;

    public static float timeScale
    {
        get => s_TimeScale;
        set
        {
            if (value is >= 0f and <= 100f)
                s_TimeScale = value;
            else
                Debug.LogError($"Time.timeScale is out of range: {value}. It must be between 0 and 100.");
        }
    }

    public static float fixedDeltaTime
    {
        get => s_FixedDeltaTime;
        set => s_FixedDeltaTime = Math.Clamp(value, 0.0001f, 10f);
    }

    /// <summary>The longest that deltaTime gets, before timeScale.</summary>
    public static float maximumDeltaTime
    {
        get => s_MaximumDeltaTime;
        set => s_MaximumDeltaTime = Math.Max(value, s_FixedDeltaTime);
    }

    /// <summary>Seconds that each frame takes, however long it took; 0 or less for those of the clock.</summary>
    public static float captureDeltaTime { get; set; }

    public static int captureFramerate
    {
        get => captureDeltaTime == 0f ? 0 : (int)MathF.Round(1f / captureDeltaTime);
        set => captureDeltaTime = value <= 0 ? 0f : 1f / value;
    }

    public static float deltaTime => inFixedTimeStep ? s_FixedDeltaTime : Clock.DeltaTime;
    public static float unscaledDeltaTime => inFixedTimeStep ? fixedUnscaledDeltaTime : Clock.UnscaledDeltaTime;
    public static float fixedUnscaledDeltaTime => s_TimeScale > 0f ? s_FixedDeltaTime / s_TimeScale : 0f;
    public static float smoothDeltaTime => Clock.DeltaTime;
    public static double timeAsDouble => inFixedTimeStep ? Clock.FixedTime : Clock.Now;
    public static float time => (float)timeAsDouble;
    public static double fixedTimeAsDouble => Clock.FixedTime;
    public static float fixedTime => (float)Clock.FixedTime;
    public static double unscaledTimeAsDouble => Clock.UnscaledNow;
    public static float unscaledTime => (float)Clock.UnscaledNow;
    public static double realtimeSinceStartupAsDouble => Clock.UnscaledNow;
    public static float realtimeSinceStartup => (float)Clock.UnscaledNow;
    public static float timeSinceLevelLoad => time;
    public static int frameCount => Clock.Frame;
    public static int renderedFrameCount => Clock.Frame;

    public static bool inFixedTimeStep
    {
        get
        {
            MainThread.Check("Time");
            return Clock.InFixedStep;
        }
    }
}
