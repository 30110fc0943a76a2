using System;
using System.Collections.Generic;
using System.Diagnostics;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Living insects and the order of their work in each fixed step and frame.</summary>
    internal sealed class FrameLoop : IDisposable
    {
        private readonly InsectRegistry m_Registry;
        private readonly BeatCalls m_Calls = new BeatCalls();
        private readonly List<InsectWings> m_Flying = new List<InsectWings>();
        private readonly AssetWatch<WingPreset, PresetValues> m_Presets = new AssetWatch<WingPreset, PresetValues>(
            asset => new PresetValues(asset));
        private readonly WindZones m_WindZones = new WindZones();
        private readonly Viewers m_Viewers = new Viewers();
        private readonly Clocks m_Clocks = new Clocks();
        private GuardedVector m_Gravity;
        private long m_StepsTold;

        public FrameLoop()
        {
            World = new WingWorld { JointMemory = Skins.Table };
            m_Registry = new InsectRegistry(World, m_Presets, Skins);
        }

        /// <summary>The simulation.</summary>
        public WingWorld World { get; }

        /// <summary>Joints and materials by which the graphics card deforms wings.</summary>
        public GpuSkins Skins { get; } = new GpuSkins();

        /// <summary>Insects whose wings beat.</summary>
        public int Count => Insects.Count;

        private List<LiveInsect> Insects => m_Registry.Living;

        /// <summary>True where no insect lives, waits or is broken.</summary>
        public bool IsEmpty => m_Registry.IsEmpty;

        /// <summary>Time within the last step of a clock that was drawn last, 0 its start, 1 its end.</summary>
        public float DrawnAlpha(WingUpdateMode clock) => m_Clocks.times[clock].alpha;

        /// <summary>Time by which the picture is behind the last step of a clock, seconds.</summary>
        public float DrawnBehind(WingUpdateMode clock) => (1f - m_Clocks.times[clock].alpha) * m_Clocks.times[clock].length;

        /// <summary>Step jobs scheduled so far.</summary>
        public long StepCount { get; private set; }

        /// <summary>Time of the main thread for the wings of a frame, mean over the last ones, milliseconds.</summary>
        public float MeanTime => m_Viewers.Budget.Mean;

        /// <summary>Looks for wind zones before the next step.</summary>
        public void FindWindZones() => m_WindZones.Forget();

        /// <summary>Queues an insect; it starts in the next frame that has time for it.</summary>
        public void Enter(InsectWings insect) => m_Registry.Enter(insect);

        /// <summary>Ends an insect: its meshes are restored now, its wings leave the world in the next frame.</summary>
        public void Leave(InsectWings insect) => m_Registry.Leave(insect);

        /// <summary>Runs one fixed step of the physics.</summary>
        public void FixedStep(float dt)
        {
            long start = Stopwatch.GetTimestamp();
            using (SystemMarkers.fixedStep.Auto())
            {
                Wait();
                ApplyParameters(physics: true);
                UpdateSurroundings(physics: true);
                m_Clocks.FixedStep(dt, Insects);
                PrepareFlights(physics: true);
                Schedule();
                JobHandle.ScheduleBatchedJobs();
            }

            Spend(start);
        }

        /// <summary>Runs the end of a frame: starts and removes insects, steps the clocks of the frame, and skins the meshes.</summary>
        public void Frame(float dt, float unscaledDt)
        {
            long start = Stopwatch.GetTimestamp();
            using (SystemMarkers.frame.Auto())
            {
                Wait();
                m_Presets.EndRound();
                if (m_Registry.UpdateRegistry())
                {
                    m_Clocks.MoveAll();
                    m_WindZones.Invalidate();
                }

                ApplyParameters(physics: false);
                SampleMotion(dt, unscaledDt);
                ChooseDetail();
                UpdateSurroundings(physics: false);
                m_Clocks.Frame(dt, unscaledDt, Insects);
                PrepareFlights(physics: false);
                Schedule();
                Draw();
                m_Calls.RaiseBeatEvents(Insects, World);
            }

            WriteCounters();
            Spend(start);
            m_Viewers.Budget.EndFrame(WingSystem.Budget);
        }

        /// <summary>Steps one insect by hand; starts it now where it still waits.</summary>
        public void StepByHand(InsectWings insect, float dt)
        {
            World.Complete();
            m_Registry.StartNow(insect);
            LiveInsect live = insect.Live;
            if (live == null)
                return;
            m_Presets.Refresh();
            live.ApplyParameters(World, m_Presets);
            live.Pace(World, WingDetail.Full, false, m_Clocks);
            SampleMotion(live, dt);
            m_WindZones.Read(Time.time);
            float3 gravity = Gravity();
            UpdateSurroundings(live, gravity);
            int steps = math.clamp((int)math.ceil(dt / Clocks.FrameStep - 1e-3f), 1, Clocks.MostSteps);
            float length = math.min(dt / steps, Clocks.FrameStep);
            live.insect.Flyer?.Prepare(live, World, live.flight.wind, gravity, length, steps);
            for (int step = 0; step < steps; step++)
                World.StepNow(live.owner, length);
            m_Clocks.times[WingUpdateMode.Manual].moved = true;
        }

        /// <summary>Restarts an insect's wings.</summary>
        public void Restart(LiveInsect live)
        {
            live.Restart(World);
            m_Clocks.times[live.Clock].moved = true;
        }

        public void Dispose()
        {
            m_Registry.End();
            World.Dispose();
            Skins.Dispose();
            SystemCounter.insects.Set(0);
            SystemCounter.steps.Set(0);
            SystemCounter.resets.Set(0);
        }

        private void Spend(long start) =>
            m_Viewers.Budget.Spend((float)((Stopwatch.GetTimestamp() - start) * 1000.0 / Stopwatch.Frequency));

        private void ApplyParameters(bool physics)
        {
            using (SystemMarkers.parameters.Auto())
            {
                m_Presets.Refresh();
                foreach (LiveInsect live in Insects)
                {
                    if (Clocks.Advances(physics, live.Clock))
                        live.ApplyParameters(World, m_Presets);
                }
            }
        }

        private void SampleMotion(float dt, float unscaledDt)
        {
            using (SystemMarkers.motion.Auto())
            {
                foreach (LiveInsect live in Insects)
                {
                    if (live.Clock != WingUpdateMode.Manual)
                        SampleMotion(live, live.Clock == WingUpdateMode.UnscaledTime ? unscaledDt : dt);
                }
            }
        }

        private void SampleMotion(LiveInsect live, float dt)
        {
            if (live.SampleMotion(dt) && live.insect.MotionSettings.onTeleport == TeleportResponse.Reset)
                Restart(live);
        }

        private void ChooseDetail()
        {
            using (SystemMarkers.detail.Auto())
            {
                m_Viewers.UpdateCameras();
                foreach (LiveInsect live in Insects)
                {
                    if (live.ChooseDetail(World, m_Viewers, m_Clocks))
                        m_Clocks.times[live.Clock].moved = true;
                }
            }
        }

        private void UpdateSurroundings(bool physics)
        {
            using (SystemMarkers.surroundings.Auto())
            {
                m_WindZones.Read(Time.time);
                float3 gravity = Gravity();
                foreach (LiveInsect live in Insects)
                {
                    if (Clocks.Advances(physics, live.Clock) && (live.Detail != WingDetail.Frozen || live.insect.Flyer != null))
                        UpdateSurroundings(live, gravity);
                }
            }
        }

        private void UpdateSurroundings(LiveInsect live, float3 gravity)
        {
            live.UpdateSurroundings(gravity, m_WindZones);
            bool hasSize = live.WriteSurroundings(World);
            if (hasSize)
                live.insect.Report(InsectProblem.None);
            else if (live.insect.State != InsectState.ZeroScale)
                live.insect.Report(InsectProblem.NoSize);
        }

        private void PrepareFlights(bool physics)
        {
            float3 gravity = Gravity();
            m_Flying.Clear();
            foreach (LiveInsect live in Insects)
            {
                if (live.insect.Flyer != null && m_Clocks.times[live.Clock].IsDue && Clocks.Advances(physics, live.Clock))
                    m_Flying.Add(live.insect);
            }

            // A pilot may switch insects off.
            foreach (InsectWings insect in m_Flying)
            {
                if (insect.Live is { } live && insect.Flyer is { } flyer)
                {
                    flyer.Prepare(
                        live, World, live.flight.wind, gravity, m_Clocks.times[live.Clock].length, m_Clocks.times[live.Clock].count);
                }
            }
        }

        private float3 Gravity() => m_Gravity.Guard(Physics.gravity, OuterBounds.Gravity, "a gravity (Physics.gravity)", "m/s²", null);

        private void Schedule()
        {
            if (!m_Clocks.times.AnyDue())
                return;
            using (SystemMarkers.schedule.Auto())
                World.ScheduleStep(m_Clocks.times);
            StepCount++;
        }

        private void Wait()
        {
            using (SystemMarkers.wait.Auto())
                World.Complete();
        }

        private void Draw()
        {
            foreach (LiveInsect live in Insects)
            {
                if (live.insect.Flyer is { } flyer)
                    flyer.Show(live, World, m_Clocks.times[live.Clock].alpha);
            }

            using (SystemMarkers.upload.Auto())
                Skins.BeginPicture();
            if (m_Clocks.times.AnyDrawn())
            {
                using (SystemMarkers.schedule.Auto())
                    World.ScheduleSkin(m_Clocks.times);
                Wait();
            }

            using (SystemMarkers.upload.Auto())
            {
                foreach (LiveInsect live in Insects)
                    live.Upload(World, m_Clocks.times[live.Clock].IsDrawn);
                Skins.EndPicture();
            }

            m_Clocks.EndDrawing();
        }

        private void WriteCounters()
        {
            SystemCounter.insects.Set(Count);
            SystemCounter.steps.Set((int)(StepCount - m_StepsTold));
            m_StepsTold = StepCount;
            if (SystemCounter.resets.IsKept)
                SystemCounter.resets.Set(World.CountResets());
        }
    }
}
