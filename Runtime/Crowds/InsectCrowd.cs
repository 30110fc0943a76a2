using System;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>
    /// Draws thousands of baked insects with few draw calls. A script writes <see cref="Poses"/>; the crowd advances the loops, and for
    /// each camera that draws, once it has moved, leaves out what it does not see and takes the mesh for each insect's height in its
    /// picture. The nearest few can be live insects.
    /// </summary>
    [AddComponentMenu("Alate/Insect Crowd")]
    [DefaultExecutionOrder(ExecutionOrders.Crowd)]
    [DisallowMultipleComponent]
    public sealed class InsectCrowd : MonoBehaviour
    {
        /// <summary>Most insects of a crowd.</summary>
        public const int MaxCount = 1000000;

        [SerializeField]
        [Tooltip("The baked insect that is drawn.")]
        private BakedInsect m_Insect;

        [SerializeField]
        [Range(0, MaxCount)]
        [Tooltip("Insects of the crowd, 0 to 1,000,000.")]
        private int m_Count = 1000;

        [SerializeField]
        [Tooltip("The camera whose nearest insects are live. None: the main camera. Every camera draws what it sees itself.")]
        private Camera m_Camera;

        [SerializeField]
        [Tooltip("Whether the insects cast shadows.")]
        private ShadowCastingMode m_Shadows = ShadowCastingMode.Off;

        [SerializeField]
        [Tooltip("Rendering layers of the insects, a bit each: lights and decals of these layers act on them. 1: the default layer.")]
        private uint m_RenderingLayers = 1;

        [SerializeField]
        [Tooltip("Gives the baked insects motion vectors, for temporal antialiasing and motion blur in URP. Costs 96 bytes an insect; "
            + "leave it off without such effects.")]
        private bool m_MotionVectors;

        [SerializeField]
        [Tooltip("A live insect of the kind that was baked; copies of it take the places of the nearest. None: all are baked.")]
        private InsectWings m_LivePrefab;

        [SerializeField]
        [Range(0, CrowdTwins.MaxCount)]
        [Tooltip("How many of the nearest are live, 0 to 64.")]
        private int m_LiveCount = 8;

        private CrowdBuffers m_Buffers;
        private CrowdBatches m_Batches;
        private CrowdCameras m_Cameras;
        private CrowdTwins m_Twins;
        private JobHandle m_Pending;
        private int m_DrawnFrame, m_DrawnCount;
        private bool m_Told;

        /// <summary>The baked insect; a change empties the crowd.</summary>
        public BakedInsect Insect
        {
            get => m_Insect;
            set
            {
                if (ReferenceEquals(m_Insect, value))
                    return;
                m_Insect = value;
                Free();
            }
        }

        /// <summary>Insects, 0 to <see cref="MaxCount"/>; a change empties the crowd.</summary>
        /// <exception cref="ArgumentOutOfRangeException">Too many, or fewer than none.</exception>
        public int Count
        {
            get => Mathf.Clamp(m_Count, 0, MaxCount);
            set
            {
                if (value < 0 || value > MaxCount)
                    throw new ArgumentOutOfRangeException(nameof(value), value, $"A crowd has 0 to {MaxCount} insects.");
                if (value == m_Count)
                    return;
                m_Count = value;
                Free();
            }
        }

        /// <summary>The camera whose nearest insects are live; null is the main camera. Every camera draws what it sees itself.</summary>
        public Camera Camera
        {
            get => m_Camera;
            set => m_Camera = value;
        }

        /// <summary>Rendering layers of the baked insects, a bit each; 1 is the default layer.</summary>
        public uint RenderingLayers
        {
            get => m_RenderingLayers;
            set => m_RenderingLayers = value;
        }

        /// <summary>
        /// True where the baked insects have motion vectors in URP, for temporal antialiasing and motion blur; 96 bytes an insect. Live
        /// ones have their own (<see cref="InsectQuality.motionVectors"/>).
        /// </summary>
        public bool MotionVectors
        {
            get => m_MotionVectors;
            set => m_MotionVectors = value;
        }

        /// <summary>A live insect of the kind that was baked, in the scene or as a prefab; null leaves all baked.</summary>
        public InsectWings LivePrefab
        {
            get => m_LivePrefab;
            set => m_LivePrefab = value;
        }

        /// <summary>Number of the nearest insects that are live, 0 to 64 (clamped).</summary>
        public int LiveCount
        {
            get => Mathf.Clamp(m_LiveCount, 0, CrowdTwins.MaxCount);
            set
            {
                int count = Mathf.Clamp(value, 0, CrowdTwins.MaxCount);
                if (count == m_LiveCount)
                    return;
                m_LiveCount = count;
                m_Twins?.Release(0);
            }
        }

        /// <summary>
        /// The insects, to be written by a script at any time: places, loops, tints. Valid until the count or the insect changes, or the
        /// component is disabled. Insects that nobody has written have scale 0 and are not drawn.
        /// </summary>
        public NativeArray<CrowdPose> Poses
        {
            get
            {
                m_Pending.Complete();
                Prepare();
                return m_Buffers == null ? default : m_Buffers.poses;
            }
        }

        /// <summary>
        /// Insects that were drawn baked in the last frame that a camera drew, once for each camera that saw them or their shadows.
        /// </summary>
        public int DrawnCount => m_Buffers == null ? 0 : m_DrawnCount;

        /// <summary>Insects that are live now.</summary>
        public int LiveNow => m_Twins == null ? 0 : m_Twins.ShownCount;

        /// <summary>The live insect that stands for one of the crowd; null where that is baked.</summary>
        public InsectWings LiveTwinOf(int insect) => m_Twins?.ShownFor(insect);

        /// <summary>Draw calls of the last frame that a camera drew, for all cameras.</summary>
        public int DrawCalls => m_Batches == null ? 0 : m_Batches.Calls;

        /// <summary>Triangles of the last frame that a camera drew, for all cameras.</summary>
        public long Triangles => m_Batches == null ? 0 : m_Batches.Triangles;

        /// <summary>The state in one line: what keeps the crowd from being drawn; null when all is well.</summary>
        public string Problem => m_Insect == null ? "No baked insect is assigned."
            : m_Insect.Sizes.Count == 0 || m_Insect.Sizes.Count > CrowdCullJob.MaxSizes
            ? $"'{m_Insect.name}' has {m_Insect.Sizes.Count} meshes; 1 to {CrowdCullJob.MaxSizes} can be drawn."
            : m_Insect.Loops.Count == 0 ? $"'{m_Insect.name}' has no loops. Bake it again."
            : !SystemInfo.supportsInstancing
            ? "This device draws no instances: crowds cannot be drawn. Use fewer insects with the component Insect Wings."
            : null;

        /// <summary>One frame without a camera on the calling thread, for measurements.</summary>
        internal void RunFrame(float seconds) => Begin(seconds);

        /// <summary>Draws for a camera as when it begins to, for measurements.</summary>
        internal void RunCamera(Camera eye) => Draw(eye);

        private void OnDisable() => Free();

        private void Update() => Begin(Time.deltaTime);

        private void Begin(float seconds)
        {
            if (!Prepare())
                return;
            Camera eye = m_Camera != null ? m_Camera : Camera.main;
            m_Pending.Complete();
            m_Twins.Update(m_LivePrefab, eye == null ? 0 : LiveCount, m_Insect, m_Buffers, seconds);
            var job = new CrowdStepJob
            {
                seconds = seconds,
                shape = Shape,
                ranks = eye != null && m_LivePrefab != null && LiveCount > 0,
                view = eye == null ? default : CameraView.Of(eye, false),
                loops = m_Buffers.loops,
                poses = m_Buffers.poses,
                spheres = m_Buffers.spheres,
                instances = m_Buffers.instances,
                nearest = m_Buffers.nearest,
                nearestDistances = m_Buffers.nearestDistances,
            };
            job.Validate();
            m_Pending = job.Schedule();
            JobHandle.ScheduleBatchedJobs();
        }

        private void Draw(Camera eye)
        {
            m_Pending.Complete();
            if (m_Buffers == null || m_Insect == null)
                return;
            if (m_DrawnFrame != Time.frameCount)
            {
                m_DrawnFrame = Time.frameCount;
                m_DrawnCount = 0;
                m_Batches.Begin();
            }

            CrowdCullJob job = CullJob(CameraView.Of(eye, m_Shadows != ShadowCastingMode.Off));
            job.Validate();
            job.Run();
            for (int size = 0; size < CrowdCullJob.MaxSizes; size++)
                m_DrawnCount += m_Buffers.counts[size];
            m_Batches.Draw(m_Insect, m_Buffers, new RenderParams(null)
            {
                camera = eye,
                layer = gameObject.layer,
                renderingLayerMask = m_RenderingLayers,
                shadowCastingMode = m_Shadows,
                receiveShadows = true,
                motionVectorMode = Moves ? MotionVectorGenerationMode.Object : MotionVectorGenerationMode.Camera,
            });
        }

        private bool Prepare()
        {
            m_Pending.Complete();
            string problem = Problem;
            if (m_Buffers != null && problem == null && m_Buffers.Fits(Count, m_Insect))
            {
                PrepareMotion();
                return true;
            }

            // The inspector and undo write fields at any time, and an asset can be deleted or baked again while it is drawn.
            if (m_Buffers != null)
                Free();
            if (problem != null || !isActiveAndEnabled)
            {
                if (problem != null && !m_Told)
                    Debug.LogWarning($"'{name}': {problem}", this);
                m_Told = problem != null;
                return false;
            }

            m_Insect.FreeCopies();
            m_Buffers = new CrowdBuffers(Count, 2 * CrowdTwins.MaxCount, m_Insect);
            m_Twins = new CrowdTwins(gameObject.scene);
            m_Cameras = new CrowdCameras(gameObject, Draw);
            PrepareMotion();
            return true;
        }

        private void PrepareMotion()
        {
            bool moves = Moves;
            m_Buffers.SetMotion(moves);
            if (m_Batches != null && m_Batches.Moves == moves)
                return;
            m_Batches?.Dispose();
            m_Batches = new CrowdBatches(moves);
        }

        // The built-in pipeline draws no instances in its pass of motion vectors.
        private bool Moves => m_MotionVectors && GraphicsSettings.currentRenderPipeline != null;

        private CrowdShape Shape => new CrowdShape { centre = m_Insect.Bounds.center, radius = m_Insect.Bounds.extents.magnitude };

        private CrowdCullJob CullJob(in CrowdView view)
        {
            var job = new CrowdCullJob
            {
                view = view,
                sizeCount = m_Insect.Sizes.Count,
                sorts = m_Buffers.IsTranslucent,
                loops = m_Buffers.loops,
                poses = m_Buffers.poses,
                hidden = m_Buffers.hidden,
                hiddenCount = m_Twins.ShownCount,
                spheres = m_Buffers.spheres,
                instances = m_Buffers.instances,
                sizes = m_Buffers.sizes,
                order = m_Buffers.order,
                counts = m_Buffers.counts,
                seen = m_Buffers.seen,
            };
            for (int size = 0; size < job.sizeCount; size++)
                job.screenHeights[size] = size + 1 < job.sizeCount ? m_Insect.Sizes[size + 1].screenHeight : 0f;
            return job;
        }

        private void Free()
        {
            m_Pending.Complete();
            m_Cameras?.Dispose();
            m_Batches?.Dispose();
            m_Twins?.Dispose();
            m_Buffers?.Dispose();
            m_Cameras = null;
            m_Twins = null;
            m_Buffers = null;
            m_Batches = null;
            m_Told = false;
            m_DrawnCount = 0;
        }
    }
}
