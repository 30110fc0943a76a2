using System;
using System.Collections.Generic;
using Alate.Crowds;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Proof
{
    /// <summary>
    /// A frame of a crowd: places by the spawner's job, phases and spheres by the step's, and what a camera sees by the culling job.
    /// </summary>
    internal sealed class CrowdGolden : IDisposable
    {
        private const int k_Count = 256, k_Sizes = 3;
        private const float k_FrameTime = 1f / 60f, k_FieldOfView = 60f, k_Far = 100f;

        /// <summary>Distance that is allowed, m: the places are up to ten metres from the middle.</summary>
        private const float k_Allowed = 1e-4f;

        /// <summary>Angles that insects have flown after some seconds, radians.</summary>
        private static readonly float2 s_Turned = new float2(0.7f, 1.2f), s_TurnedMore = new float2(0.1f, 0.2f);

        private NativeArray<CrowdPose> m_Poses = new NativeArray<CrowdPose>(k_Count, Allocator.Persistent);
        private NativeArray<float4> m_Spheres = new NativeArray<float4>(k_Count, Allocator.Persistent);
        private NativeArray<LoopRows> m_Loops = new NativeArray<LoopRows>(1, Allocator.Persistent);
        private NativeArray<int> m_Nearest = new NativeArray<int>(8, Allocator.Persistent);
        private NativeArray<float> m_Distances = new NativeArray<float>(8, Allocator.Persistent);
        private NativeArray<int> m_Hidden = new NativeArray<int>(1, Allocator.Persistent);
        private NativeArray<byte> m_Sizes = new NativeArray<byte>(k_Count, Allocator.Persistent);
        private NativeArray<int> m_Seen = new NativeArray<int>(k_Count, Allocator.Persistent);
        private NativeArray<int> m_Counts = new NativeArray<int>(CrowdCullJob.MaxSizes, Allocator.Persistent);
        private CrowdInstances m_Instances = new CrowdInstances(k_Count);
        private CrowdOrder m_Order = new CrowdOrder(k_Count);

        public CrowdGolden()
        {
            m_Loops[0] = new LoopRows { frequency = 10f, first = 0, count = 48 };
        }

        /// <summary>Places, advances and culls.</summary>
        public GoldenTrack Run()
        {
            new SpawnJob
            {
                toWorld = float4x4.TRS(new float3(1f, 2f, 3f), quaternion.RotateY(0.5f), 1f),
                half = new float3(10f, 3f, 10f),
                turned = s_Turned,
                turnedMore = s_TurnedMore,
                sizes = 0.2f,
                attitude = quaternion.identity,
                seed = 5,
                poses = m_Poses,
            }.Schedule(k_Count, default).Complete();
            CrowdView view = View();
            new CrowdStepJob
            {
                seconds = k_FrameTime,
                shape = new CrowdShape { centre = new float3(0f, 0.1f, 0f), radius = 0.6f },
                view = view,
                ranks = true,
                loops = m_Loops,
                poses = m_Poses,
                instances = m_Instances,
                spheres = m_Spheres,
                nearest = m_Nearest,
                nearestDistances = m_Distances,
            }.Schedule().Complete();
            new CrowdCullJob
            {
                view = view,
                screenHeights = new float4(0.1f, 0.05f, 0f, 0f),
                sizeCount = k_Sizes,
                sorts = true,
                loops = m_Loops,
                poses = m_Poses,
                spheres = m_Spheres,
                hidden = m_Hidden,
                instances = m_Instances,
                sizes = m_Sizes,
                order = m_Order,
                counts = m_Counts,
                seen = m_Seen,
            }.Schedule().Complete();
            return new GoldenTrack($"crowd: a frame of {k_Count} insects, places in m, rows and numbers", Things(), k_Allowed, Values());
        }

        public void Dispose()
        {
            m_Poses.Dispose();
            m_Spheres.Dispose();
            m_Loops.Dispose();
            m_Nearest.Dispose();
            m_Distances.Dispose();
            m_Hidden.Dispose();
            m_Sizes.Dispose();
            m_Seen.Dispose();
            m_Counts.Dispose();
            m_Instances.Dispose();
            m_Order.Dispose();
        }

        private static CrowdView View()
        {
            var eye = new float3(0f, 3f, -14f);
            Matrix4x4 world = Matrix4x4.TRS(eye, Quaternion.identity, new Vector3(1f, 1f, -1f)).inverse;
            var picture = Matrix4x4.Perspective(k_FieldOfView, 16f / 9f, 0.1f, k_Far);
            var planes = new Plane[6];
            GeometryUtility.CalculateFrustumPlanes(picture * world, planes);
            return new CrowdView
            {
                eye = eye,
                ahead = new float3(0f, 0f, 1f),
                halfHeight = math.tan(0.5f * math.radians(k_FieldOfView)),
                frustum = CrowdFrustum.Of(planes),
            };
        }

        private static string[] Things()
        {
            string[] names = new string[3 * k_Count + 2];
            for (int k = 0; k < k_Count; k++)
            {
                names[3 * k] = $"insect {k}, place";
                names[3 * k + 1] = $"insect {k}, row before, row after, share";
                names[3 * k + 2] = $"insect {k}, mesh, place in the order, phase";
            }

            names[3 * k_Count] = "insects of the three meshes";
            names[3 * k_Count + 1] = "the nearest three";
            return names;
        }

        private float[] Values()
        {
            int[] places = new int[k_Count];
            int drawn = m_Counts[0] + m_Counts[1] + m_Counts[2];
            for (int k = 0; k < k_Count; k++)
                places[k] = -1;
            for (int k = 0; k < drawn; k++)
                places[m_Seen[k]] = k;
            var values = new List<float>();
            for (int k = 0; k < k_Count; k++)
            {
                bool seen = places[k] >= 0;
                GoldenTrack.Add(values, m_Spheres[k].xyz);
                GoldenTrack.Add(values, seen ? m_Instances.rows[k].xyz : default);
                GoldenTrack.Add(values, new float3(seen ? m_Sizes[k] : -1f, places[k], m_Poses[k].phase));
            }

            GoldenTrack.Add(values, new float3(m_Counts[0], m_Counts[1], m_Counts[2]));
            GoldenTrack.Add(values, new float3(m_Nearest[0], m_Nearest[1], m_Nearest[2]));
            return values.ToArray();
        }
    }
}
