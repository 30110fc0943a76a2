using System;
using System.Collections.Generic;
using StandIns;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Unity.StandIns;

/// <summary>
/// Unity's frame, driven by hand: Start; fixed steps with FixedUpdate; Update, coroutines, LateUpdate, cameras,
/// end of frame; destruction.
/// Scenes are not reloaded when play begins: objects made before go on as they are.
/// </summary>
[StandInExtension]
public static class PlayerLoop
{
    private static readonly Func<BehaviourMessages, Action> s_FixedUpdate = m => m.FixedUpdate;
    private static readonly Func<BehaviourMessages, Action> s_Update = m => m.Update;
    private static readonly Func<BehaviourMessages, Action> s_LateUpdate = m => m.LateUpdate;
    private static readonly Func<BehaviourMessages, Action> s_OnGui = m => m.OnGUI;
    private static readonly Action s_DrawAll = () => BehaviourList.Send(s_OnGui);
    private static bool s_Ticking;

    /// <summary>Raised after the frame's last coroutine, before destroyed objects end.</summary>
    public static event Action FrameEnding;

    /// <summary>Value of Application.isPlaying.</summary>
    public static bool IsPlaying { get; private set; }

    /// <summary>Starts the clock at 0, runs RuntimeInitializeOnLoadMethod methods and awakes the loaded scenes.</summary>
    public static void EnterPlayMode()
    {
        MainThread.Adopt();
        if (IsPlaying)
            throw new InvalidOperationException("Play mode was entered already.");
        foreach (MonoBehaviour behaviour in BehaviourList.Snapshot())
        {
            // What has outlived its scene goes on, as without a reload of the domain.
            if (behaviour.Owner.transform.Root.Home == null)
                continue;
            Lifecycle.Deactivate(behaviour);
            behaviour.Awoken = behaviour.Started = false;
        }

        Clock.Reset();
        DrawnScreen.Forget();
        IsPlaying = true;
        LoadMethods.Run(RuntimeInitializeLoadType.SubsystemRegistration);
        LoadMethods.Run(RuntimeInitializeLoadType.AfterAssembliesLoaded);
        LoadMethods.Run(RuntimeInitializeLoadType.BeforeSplashScreen);
        LoadMethods.Run(RuntimeInitializeLoadType.BeforeSceneLoad);
        Lifecycle.Activate(ObjectRegistry.Find<MonoBehaviour>(typeof(MonoBehaviour), b => b.Owner.ActiveFlag));
        LoadMethods.Run(RuntimeInitializeLoadType.AfterSceneLoad);
    }

    /// <summary>One frame that took so many seconds, 0 or more.</summary>
    public static void Tick(float frameTime)
    {
        if (!(frameTime >= 0f) || float.IsInfinity(frameTime))
            throw new ArgumentOutOfRangeException(nameof(frameTime), frameTime, "A frame takes 0 seconds or more.");
        if (s_Ticking)
            throw new InvalidOperationException("A frame is under way.");
        s_Ticking = true;
        try
        {
            Frame(frameTime);
        }
        finally
        {
            s_Ticking = false;
            Clock.InFixedStep = false;
        }
    }

    /// <summary>Ends all objects of all scenes. Those marked DontSave live on, as in Unity.</summary>
    public static void ExitPlayMode()
    {
        if (!IsPlaying)
            throw new InvalidOperationException("Play mode was not entered.");
        foreach (MonoBehaviour behaviour in BehaviourList.Snapshot())
            behaviour.Messages.Send("OnApplicationQuit");
        Application.ReportQuitting();
        Doomed.Forget();
        foreach (SceneRecord scene in new List<SceneRecord>(SceneRecord.Loaded))
            scene.Unload();
        SceneRecord.Lasting.Unload();

        // What was destroyed meanwhile waits for the end of a frame that never comes.
        Doomed.Forget();
        IsPlaying = false;
        NativeMemoryLedger.EndFrame();
        Clock.Reset();
    }

    private static void Frame(float frameTime)
    {
        Clock.BeginFrame(frameTime);
        BehaviourList.StartNew();
        while (IsPlaying && Clock.NextFixedStep())
        {
            Clock.InFixedStep = true;
            BehaviourList.Send(s_FixedUpdate);
            Rigidbody.StepAll(Time.fixedDeltaTime);
            CoroutineSet.ResumeAll(FramePoint.FixedUpdate);
            Clock.InFixedStep = false;
        }

        DrawnScreen.BeginFrame();
        BehaviourList.Send(s_Update);
        CoroutineSet.ResumeAll(FramePoint.Update);
        BehaviourList.Send(s_LateUpdate);
        DrawnCameras.DrawAll();
        if (IsPlaying && BehaviourList.AnyHears(s_OnGui))
            DrawnScreen.Draw(s_DrawAll);
        CoroutineSet.ResumeAll(FramePoint.EndOfFrame);
        JobHandle.ScheduleBatchedJobs();
        FrameEnding?.Invoke();
        Visibility.Update();
        Doomed.End();
        ProfilerCounters.EndFrame();
        NativeMemoryLedger.EndFrame();
    }
}
