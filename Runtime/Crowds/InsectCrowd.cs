using System;
using Alate.Geometry;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>
    /// Draws thousands of baked insects with few draw calls. A script writes <see cref="Poses"/>; the crowd advances the loops, leaves out
    /// what the camera does not see, and draws each insect with the mesh for its height on the screen. The nearest few can be live insects.
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
        [Tooltip("The camera that insects are culled and sized for. None: the main camera.")]
        private Camera m_Camera;

        [SerializeField]
        [Tooltip("Whether the insects cast shadows.")]
        private ShadowCastingMode m_Shadows = ShadowCastingMode.Off;

        [SerializeField]
        [Tooltip("A live insect of the kind that was baked; copies of it take the places of the nearest. None: all are baked.")]
        private InsectWings m_LivePrefab;

        [SerializeField]
        [Range(0, CrowdTwins.MaxCount)]
        [Tooltip("How many of the nearest are live, 0 to 64.")]
        private int m_LiveCount = 8;

        private readonly Plane[] m_Planes = new Plane[6];
        private CrowdBuffers m_Buffers;
        private CrowdBatches m_Batches;
        private CrowdTwins m_Twins;
        private JobHandle m_Pending;
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
            get => m_Count;
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

        /// <summary>The camera that insects are culled and sized for; null is the main camera.</summary>
        public Camera Camera
        {
            get => m_Camera;
            set => m_Camera = value;
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
            get => m_LiveCount;
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

        /// <summary>Insects that were drawn baked in the last frame.</summary>
        public int DrawnCount { get; private set; }

        /// <summary>Insects that are live now.</summary>
        public int LiveNow => m_Twins == null ? 0 : m_Twins.ShownCount;

        /// <summary>The live insect that stands for one of the crowd; null where that is baked.</summary>
        public InsectWings LiveTwinOf(int insect) => m_Twins?.ShownFor(insect);

        /// <summary>Draw calls of the last frame.</summary>
        public int DrawCalls => m_Batches == null ? 0 : m_Batches.Calls;

        /// <summary>Triangles of the last frame.</summary>
        public long Triangles => m_Batches == null ? 0 : m_Batches.Triangles;

        /// <summary>The state in one line: what keeps the crowd from being drawn; null when all is well.</summary>
        public string Problem => m_Insect == null ? "No baked insect is assigned."
            : m_Insect.Sizes.Count == 0 || m_Insect.Sizes.Count > CrowdJob.MaxSizes
            ? $"'{m_Insect.name}' has {m_Insect.Sizes.Count} meshes; 1 to {CrowdJob.MaxSizes} can be drawn."
            : m_Insect.Loops.Count == 0 ? $"'{m_Insect.name}' has no loops. Bake it again."
            : !SystemInfo.supportsInstancing
            ? "This device draws no instances: crowds cannot be drawn. Use fewer insects with the component Insect Wings."
            : null;

        /// <summary>One frame on the calling thread, for measurements.</summary>
        internal void RunFrame(float seconds)
        {
            Begin(seconds);
            LateUpdate();
        }

        /// <summary>Draws the last frame again, for measurements.</summary>
        internal void RunDrawing() => LateUpdate();

        private void OnDisable() => Free();

        private void Update() => Begin(Time.deltaTime);

        private void Begin(float seconds)
        {
            if (!Prepare())
                return;
            Camera eye = m_Camera != null ? m_Camera : Camera.main;
            m_Pending.Complete();
            m_Twins.Update(m_LivePrefab, eye == null ? 0 : m_LiveCount, m_Insect, m_Buffers, seconds);
            CrowdJob job = Job(eye, seconds);
            job.Validate();
            m_Pending = job.Schedule();
            JobHandle.ScheduleBatchedJobs();
        }

        private void LateUpdate()
        {
            m_Pending.Complete();
            DrawnCount = 0;
            if (m_Buffers == null || m_Insect == null)
                return;
            for (int size = 0; size < CrowdJob.MaxSizes; size++)
                DrawnCount += m_Buffers.counts[size];
            if (DrawnCount > 0)
                m_Batches.Draw(m_Insect, m_Buffers, m_Buffers.Bounds, gameObject.layer, m_Shadows);
        }

        private bool Prepare()
        {
            m_Pending.Complete();
            string problem = Problem;
            if (m_Buffers != null && problem == null && m_Buffers.Fits(m_Count, m_Insect))
                return true;

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

            m_Buffers = new CrowdBuffers(m_Count, 2 * CrowdTwins.MaxCount, m_Insect);
            m_Batches = new CrowdBatches();
            m_Twins = new CrowdTwins(gameObject.scene);
            return true;
        }

        private CrowdJob Job(Camera eye, float seconds)
        {
            var job = new CrowdJob
            {
                seconds = seconds,
                radius = m_Insect.Bounds.extents.magnitude,
                centre = m_Insect.Bounds.center,
                culls = eye != null,
                sizeCount = m_Insect.Sizes.Count,
                planes = m_Buffers.planes,
                loops = m_Buffers.loops,
                poses = m_Buffers.poses,
                sizes = m_Buffers.sizes,
                counts = m_Buffers.counts,
                matrices = m_Buffers.matrices,
                rows = m_Buffers.rows,
                nextRows = m_Buffers.nextRows,
                tints = m_Buffers.tints,
                corners = m_Buffers.corners,
                hidden = m_Buffers.hidden,
                hiddenCount = m_Twins.ShownCount,
                nearest = m_Buffers.nearest,
                nearestDistances = m_Buffers.nearestDistances,
            };
            for (int size = 0; size < job.sizeCount; size++)
                job.screenHeights[size] = size + 1 < job.sizeCount ? m_Insect.Sizes[size + 1].screenHeight : 0f;
            if (eye == null)
                return job;
            GeometryUtility.CalculateFrustumPlanes(eye, m_Planes);
            for (int plane = 0; plane < m_Planes.Length; plane++)
                m_Buffers.planes[plane] = new float4(m_Planes[plane].normal, m_Planes[plane].distance);
            job.eye = eye.transform.position;
            job.halfHeight = eye.orthographic ? 0f : Elementary.Tan(0.5f * math.radians(eye.fieldOfView));
            job.flatHeight = eye.orthographic ? eye.orthographicSize : 0f;
            return job;
        }

        private void Free()
        {
            m_Pending.Complete();
            m_Twins?.Dispose();
            m_Buffers?.Dispose();
            m_Twins = null;
            m_Buffers = null;
            m_Batches = null;
            m_Told = false;
            DrawnCount = 0;
        }
    }
}
