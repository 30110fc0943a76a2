using Alate.Catalogue;
using Alate.Crowds;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// Insects of one species over the meadow: baked at the start, and moved along circles of their own by a script that writes their
    /// poses.
    /// </summary>
    internal sealed class MeadowCrowd
    {
        private const float k_Lowest = 0.5f, k_Highest = 4f, k_Bank = 0.3f;

        private readonly InsectWings m_Prefab;
        private readonly BakedInsect m_Baked;
        private readonly float m_Radius;

        /// <param name="species">Its name in the catalogue.</param>
        /// <param name="count">Number of insects.</param>
        /// <param name="live">How many of the nearest are live.</param>
        /// <param name="radius">Half the width of the meadow, scene units.</param>
        /// <param name="parent">Of the crowd.</param>
        public MeadowCrowd(string species, int count, int live, float radius, Transform parent)
        {
            m_Radius = radius;
            m_Prefab = InsectFactory.Create(species);
            m_Prefab.transform.SetParent(parent, false);
            m_Prefab.gameObject.SetActive(false);
            InsectBake bake = InsectBaker.Bake(m_Prefab, new[] { BakeMotion.Find("cruise") }, BakeSettings.Default);
            m_Baked = BakedInsect.Create(bake);
            Crowd = new GameObject(species + " crowd").AddComponent<InsectCrowd>();
            Crowd.transform.SetParent(parent, false);
            Crowd.Insect = m_Baked;
            Crowd.Count = count;
            Crowd.LivePrefab = m_Prefab;
            Crowd.LiveCount = live;
        }

        /// <summary>Crowd that is drawn.</summary>
        public InsectCrowd Crowd { get; }

        /// <summary>Moves all insects to where they are at a time, seconds.</summary>
        public void Fly(float time)
        {
            NativeArray<CrowdPose> poses = Crowd.Poses;
            float speed = ((Vector3)m_Baked.Loops[0].velocity).magnitude;
            for (int k = 0; k < poses.Length; k++)
            {
                // Three numbers that are spread evenly and differ for each insect.
                float3 spread = math.frac(new float3(0.5545f, 0.3068f, 0.7549f) * (k + 1));
                float2 middle = m_Radius * (2f * spread.xy - 1f);
                float round = 1f + 4f * spread.z, angle = (k % 2 == 0 ? 1f : -1f) * speed / round * time + 40f * spread.x,
                    turn = k % 2 == 0 ? 1f : -1f;
                math.sincos(angle, out float sine, out float cosine);
                CrowdPose pose = poses[k];
                if (pose.scale == 0f)
                {
                    pose = CrowdPose.At(default, quaternion.identity, spread.y);
                    pose.scale = 0.85f + 0.3f * spread.z;
                }

                pose.position = new float3(
                    middle.x + round * cosine, math.lerp(k_Lowest, k_Highest, spread.z * spread.y), middle.y + round * sine);
                pose.rotation = math.mul(quaternion.LookRotation(turn * new float3(-sine, 0f, cosine), new float3(0f, 1f, 0f)),
                    quaternion.RotateZ(turn * k_Bank));
                poses[k] = pose;
            }
        }

        /// <summary>Frees what was baked.</summary>
        public void Destroy()
        {
            Crowd.enabled = false;
            m_Baked.DestroyParts();
            Object.Destroy(m_Baked);
        }
    }
}
