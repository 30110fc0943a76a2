using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Alate
{
    /// <summary>
    /// Runs all insects of the game together: steps them in one job and deforms their meshes in another. Created hidden with the first
    /// insect, and destroyed some time after the last.
    /// </summary>
    [AddComponentMenu("")]
    [DefaultExecutionOrder(ExecutionOrders.WingSystem)]
    public sealed class WingSystem : MonoBehaviour
    {
        private const float k_Patience = 10f;

        private static WingSystem s_Instance;
        private static float s_Budget;
        private FrameLoop m_Loop;
        private double m_EmptySince = double.PositiveInfinity;

        /// <summary>Insects whose wings beat.</summary>
        public static int InsectCount => Loop?.Count ?? 0;

        /// <summary>Steps since the first insect came: fixed steps, and frames in which the clocks of the frame had steps due.</summary>
        public static long StepCount => Loop?.StepCount ?? 0;

        /// <summary>
        /// Number of times that a living wing was put back into its driven pose because its state was not finite. Reads all wings.
        /// </summary>
        public static int ResetCount => Loop?.World.CountResets() ?? 0;

        /// <summary>
        /// Cameras by which levels of detail are chosen: an insect has the detail of the camera in which it is largest. Empty takes the
        /// main camera; without a camera, all insects have full detail.
        /// </summary>
        public static List<Camera> DetailCameras { get; } = new List<Camera>();

        /// <summary>
        /// Time of the main thread that the wings of all insects may take of a frame, waiting for their jobs included; milliseconds, 0 for
        /// no bound, the default. While it is exceeded, insects have less detail than their size on the screen gives them, the farther from
        /// the nearest the less; the nearest keeps its own, and none comes to rest for it. Insects without levels of detail are left alone,
        /// and without a camera all are.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The time is negative or not finite.</exception>
        public static float Budget
        {
            get => s_Budget;
            set
            {
                if (!(value >= 0f) || float.IsInfinity(value))
                    throw new ArgumentOutOfRangeException(nameof(value), value, "Must be 0 or more and finite, milliseconds.");
                s_Budget = value;
            }
        }

        /// <summary>Time of the main thread for the wings of a frame, mean over the last half second or so; milliseconds.</summary>
        public static float MeanTime => Loop?.MeanTime ?? 0f;

        /// <summary>
        /// Time for which the system and baked content wait for insects that come back, as those of a pool do; seconds of real time.
        /// </summary>
        internal static float Patience { get; set; } = k_Patience;

        /// <summary>Searches for wind zones; done automatically when a scene is loaded or an insect starts.</summary>
        public static void FindWindZones() => Loop?.FindWindZones();

        internal static FrameLoop Loop => s_Instance is null ? null : s_Instance.m_Loop;

        /// <summary>Queues an insect to start.</summary>
        internal static void Enter(InsectWings insect)
        {
            if (PlayEnd.HasCome)
                return;
            if (Loop == null)
            {
                var holder = new GameObject("Wing System") { hideFlags = HideFlags.HideInHierarchy };
                DontDestroyOnLoad(holder);
                holder.AddComponent<WingSystem>().Begin();
            }

            s_Instance.m_EmptySince = double.PositiveInfinity;
            Loop.Enter(insect);
        }

        /// <summary>Ends an insect: its meshes are restored now, its wings leave the world in the next frame.</summary>
        internal static void Leave(InsectWings insect)
        {
            if (Loop == null)
                return;
            Loop.Leave(insect);
            if (Loop.IsEmpty)
                s_Instance.m_EmptySince = Time.realtimeSinceStartupAsDouble;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            s_Instance = null;
            s_Budget = 0f;
            DetailCameras.Clear();
            Patience = k_Patience;
        }

        private void Begin()
        {
            s_Instance = this;
            m_Loop = new FrameLoop();

            // Restores all meshes and frees all memory before the scenes end.
            PlayEnd.Ended += End;
            SceneManager.sceneLoaded += OnSceneLoaded;
        }

        private void FixedUpdate() => m_Loop?.FixedStep(Time.fixedDeltaTime);

        private void LateUpdate()
        {
            // Without a loop the system was left over from before the scripts were compiled again, or was made by somebody else.
            if (m_Loop == null || Time.realtimeSinceStartupAsDouble - m_EmptySince >= Patience)
                End();
            else
                m_Loop.Frame(Time.deltaTime, Time.unscaledDeltaTime);
        }

        private void OnDisable() => End();

        private void OnSceneLoaded(Scene scene, LoadSceneMode mode) => m_Loop?.FindWindZones();

        private void End()
        {
            PlayEnd.Ended -= End;
            SceneManager.sceneLoaded -= OnSceneLoaded;
            m_Loop?.Dispose();
            m_Loop = null;
            if (ReferenceEquals(s_Instance, this))
                s_Instance = null;
            if (!PlayEnd.HasCome)
                ObjectEnd.Destroy(gameObject);
        }
    }
}
