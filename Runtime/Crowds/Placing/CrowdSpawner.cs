using System;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>
    /// Fills a crowd and lets each insect circle in a box around this object, with speed, size and phase of its own. The box lies along the
    /// object's axes; the number of insects is the crowd's.
    /// </summary>
    [AddComponentMenu("Alate/Crowd Spawner")]
    [RequireComponent(typeof(InsectCrowd))]
    [DefaultExecutionOrder(ExecutionOrders.CrowdPoses)]
    [DisallowMultipleComponent]
    public sealed class CrowdSpawner : MonoBehaviour
    {
        /// <summary>Insects of one batch of the job.</summary>
        private const int k_Batch = 256;

        private const float k_LeastSpeed = 0f, k_SlowestSpeed = 0.8f, k_FastestSpeed = 1.2f, k_MostSpeed = 4f;
        private const float k_Width = 20f, k_Height = 4f;
        private const float k_LeastVariation = 0f, k_Variation = 0.15f, k_MostVariation = 0.9f;

        [SerializeField]
        [Tooltip("Size of the box in which the insects fly, world units from side to side.")]
        private Vector3 m_Area = new Vector3(k_Width, k_Height, k_Width);

        [SerializeField]
        [Range(k_LeastSpeed, k_MostSpeed)]
        [Tooltip("Slowest insect over the speed of its loop; 0.8.")]
        private float m_SlowestSpeed = k_SlowestSpeed;

        [SerializeField]
        [Range(k_LeastSpeed, k_MostSpeed)]
        [Tooltip("Fastest insect over the speed of its loop; 1.2.")]
        private float m_FastestSpeed = k_FastestSpeed;

        [SerializeField]
        [Range(k_LeastVariation, k_MostVariation)]
        [Tooltip("How much sizes differ; 0.15 is from 0.85 to 1.15.")]
        private float m_SizeVariation = k_Variation;

        [SerializeField]
        [Tooltip("Name of the loop that is shown. Empty: the first one.")]
        private string m_Loop = "";

        [SerializeField]
        [Tooltip("Another number places all insects elsewhere.")]
        private int m_Seed = 1;

        private InsectCrowd m_Crowd;
        private float2 m_Turned, m_TurnedMore;

        /// <summary>
        /// Size of the box, world units from side to side; negative sizes count as positive ones, a size that is no number as the
        /// default's, and one beyond 10⁷ as that.
        /// </summary>
        public Vector3 Area
        {
            get => new Vector3(Side(m_Area.x, k_Width), Side(m_Area.y, k_Height), Side(m_Area.z, k_Width));
            set => m_Area = value;
        }

        /// <summary>
        /// Slowest and fastest insect over the speed of its loop, 0 to 4 (clamped); 0.8 and 1.2. The larger one is the fastest.
        /// </summary>
        public Vector2 Speeds
        {
            get
            {
                float slowest = NumberRange.Clamp(m_SlowestSpeed, k_LeastSpeed, k_MostSpeed, k_SlowestSpeed);
                float fastest = NumberRange.Clamp(m_FastestSpeed, k_LeastSpeed, k_MostSpeed, k_FastestSpeed);
                return new Vector2(Mathf.Min(slowest, fastest), Mathf.Max(slowest, fastest));
            }
            set
            {
                m_SlowestSpeed = NumberRange.Clamp(value.x, k_LeastSpeed, k_MostSpeed, k_SlowestSpeed);
                m_FastestSpeed = NumberRange.Clamp(value.y, k_LeastSpeed, k_MostSpeed, k_FastestSpeed);
            }
        }

        /// <summary>Largest difference of a size from 1, 0 to 0.9 (clamped); 0.15 is from 0.85 to 1.15.</summary>
        public float SizeVariation
        {
            get => NumberRange.Clamp(m_SizeVariation, k_LeastVariation, k_MostVariation, k_Variation);
            set => m_SizeVariation = NumberRange.Clamp(value, k_LeastVariation, k_MostVariation, k_Variation);
        }

        /// <summary>Name of the loop that is shown; empty is the first one.</summary>
        public string Loop
        {
            get => m_Loop;
            set => m_Loop = value ?? "";
        }

        /// <summary>Seed of the places; another one places all insects elsewhere.</summary>
        public int Seed
        {
            get => m_Seed;
            set => m_Seed = value;
        }

        /// <summary>
        /// Reason why the spawner places no insects, or shows the first loop in place of the one it names; null when all is well.
        /// </summary>
        public string Problem
        {
            get
            {
                BakedInsect insect = Crowd.Insect;
                return Crowd.Problem
                    ?? (string.IsNullOrEmpty(m_Loop) || insect.IndexOf(m_Loop) >= 0 ? null : $"'{insect.name}' has no loop '{m_Loop}'.");
            }
        }

        private InsectCrowd Crowd => m_Crowd != null ? m_Crowd : m_Crowd = GetComponent<InsectCrowd>();

        /// <summary>Moves all insects on by a time, seconds; called in each frame while the component is enabled.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The time is not finite.</exception>
        public void Advance(float seconds)
        {
            if (!math.isfinite(seconds))
                throw new ArgumentOutOfRangeException(nameof(seconds), seconds, "Must be finite, seconds.");
            NativeArray<CrowdPose> poses = Crowd.Poses;
            if (!poses.IsCreated)
                return;
            int loop = Mathf.Max(0, Crowd.Insect.IndexOf(m_Loop));
            CrowdLoop shown = Crowd.Insect.Loops[loop];
            Turn(seconds * math.length((float3)shown.velocity));
            var job = new SpawnJob
            {
                toWorld = float4x4.TRS(transform.position, transform.rotation, 1f),
                half = 0.5f * (float3)Area,
                turned = m_Turned,
                turnedMore = m_TurnedMore,
                sizes = SizeVariation,
                loop = loop,
                attitude = shown.attitude,
                seed = (uint)m_Seed,
                poses = poses,
            };
            job.Validate(poses.Length);
            job.ScheduleParallel(poses.Length, k_Batch, default).Complete();
        }

        private void Turn(float way)
        {
            float widest = 0.5f * Mathf.Min(Area.x, Area.z);
            float2 turned = widest > 0f ? way / widest * (float2)Speeds : default;
            if (!math.isfinite(math.csum(turned)))
                return;
            m_Turned += turned;
            m_TurnedMore += SizeVariation * turned;
        }

        private void Update() => Advance(Time.deltaTime);

        private static float Side(float size, float normal) => NumberRange.Clamp(math.abs(size), 0f, OuterBounds.Distance, normal);
    }
}
