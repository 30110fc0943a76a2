using System;
using System.Collections.Generic;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Makes the jobs of a crowd with loops of their own, and frees their memory.</summary>
    public abstract class CrowdJobFixture
    {
        internal static readonly LoopRows[] s_Loops =
        {
            new LoopRows { frequency = 10f, first = 3, count = 8 }, new LoopRows { frequency = 4f, first = 11, count = 5 },
            new LoopRows { frequency = 0f, first = 16, count = 1 },
        };

        private readonly List<IDisposable> m_Made = new List<IDisposable>();

        /// <summary>Sphere around an insect of scale 1.</summary>
        internal static CrowdShape Shape => new CrowdShape { centre = new float3(0.3f, -0.2f, 0.5f), radius = 0.7f };

        /// <summary>Frees what was kept.</summary>
        [TearDown]
        public void FreeMemory()
        {
            foreach (IDisposable made in m_Made)
                made.Dispose();
            m_Made.Clear();
        }

        /// <summary>A view of everything, from far enough for the finest mesh.</summary>
        internal static CrowdView Everything => Behind(new Plane[6]);

        /// <summary>A view of what lies behind planes; those at zero, as of a new array, leave nothing out.</summary>
        internal static CrowdView Behind(params Plane[] planes)
        {
            Array.Resize(ref planes, 6);
            return new CrowdView { halfHeight = 0.01f, ahead = new float3(0f, 0f, 1f), frustum = CrowdFrustum.Of(planes) };
        }

        internal static CrowdPose Somewhere(ref Random random)
        {
            var pose = CrowdPose.At(random.NextFloat3(-5f, 5f), random.NextQuaternionRotation());
            pose.scale = random.NextFloat(0.5f, 3f);
            return pose;
        }

        internal CrowdStepJob StepJob(CrowdPose[] poses, int ranked = 4) => new CrowdStepJob
        {
            shape = Shape,
            view = Everything,
            ranks = true,
            loops = Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent)),
            poses = Keep(new NativeArray<CrowdPose>(poses, Allocator.Persistent)),
            spheres = Keep(new NativeArray<float4>(poses.Length, Allocator.Persistent)),
            instances = Keep(new CrowdInstances(poses.Length)),
            nearest = Keep(new NativeArray<int>(ranked, Allocator.Persistent)),
            nearestDistances = Keep(new NativeArray<float>(ranked, Allocator.Persistent)),
        };

        /// <summary>Culls poses that were stepped by no time.</summary>
        internal CrowdCullJob CullJob(CrowdPose[] poses, params int[] hidden) => CullJob(Shape, poses, hidden);

        internal CrowdCullJob CullJob(CrowdShape shape, CrowdPose[] poses, params int[] hidden)
        {
            CrowdStepJob step = StepJob(poses);
            step.shape = shape;
            step.Execute();
            return new CrowdCullJob
            {
                view = Everything,
                screenHeights = new float4(0.3f, 0.1f, 0f, 0f),
                sizeCount = 3,
                loops = step.loops,
                poses = step.poses,
                spheres = step.spheres,
                instances = step.instances,
                hidden = Keep(new NativeArray<int>(hidden.Length == 0 ? new int[1] : hidden, Allocator.Persistent)),
                hiddenCount = hidden.Length,
                sizes = Keep(new NativeArray<byte>(poses.Length, Allocator.Persistent)),
                order = Keep(new CrowdOrder(poses.Length)),
                counts = Keep(new NativeArray<int>(CrowdCullJob.MaxSizes, Allocator.Persistent)),
                seen = Keep(new NativeArray<int>(poses.Length, Allocator.Persistent)),
            };
        }

        internal CrowdGatherJob GatherJob(in CrowdCullJob job, int start, int count)
        {
            var gather = new CrowdGatherJob
            {
                start = start,
                count = count,
                seen = job.seen,
                spheres = job.spheres,
                matrices = Keep(new NativeArray<float4x4>(count, Allocator.Persistent)),
                rows = Keep(new NativeArray<float4>(count, Allocator.Persistent)),
                nextRows = Keep(new NativeArray<float4>(count, Allocator.Persistent)),
                tints = Keep(new NativeArray<float4>(count, Allocator.Persistent)),
                corners = Keep(new NativeArray<float3>(2, Allocator.Persistent)),
            };
            gather.From(job.instances);
            return gather;
        }

        internal T Keep<T>(T made) where T : IDisposable
        {
            m_Made.Add(made);
            return made;
        }
    }
}
