using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Play-mode tests of small insects: two elliptic wings of one mesh each, the left one mirrored by its scale. A wing is one unit long.
    /// </summary>
    public abstract class FlockFixture : PlayFixture
    {
        /// <summary>The wing that all insects of the test share.</summary>
        protected Mesh WingMesh { get; private set; }

        /// <summary>Skeleton of the wing.</summary>
        protected WingSkeleton Skeleton { get; private set; }

        [SetUp]
        public void MakeTheWing()
        {
            WingMesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            Skeleton = Keep(TestWings.Fan());
        }

        /// <summary>An insect that begins to live, computed also where no camera sees it.</summary>
        /// <param name="prepare">Called while it is not active yet.</param>
        /// <param name="name">Of its object.</param>
        protected InsectWings Hatch(Action<InsectWings> prepare = null, string name = "insect")
        {
            GameObject root = Keep(new GameObject(name));
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
                insect.Wings.Add(MakeWing(root.transform, side));
            insect.Quality.culling = WingCulling.AlwaysSimulate;
            prepare?.Invoke(insect);
            root.SetActive(true);
            return insect;
        }

        /// <summary>A wing of the shared mesh under a body.</summary>
        protected Wing MakeWing(Transform body, WingSide side)
        {
            var drawn = new GameObject("wing " + side);
            drawn.transform.SetParent(body, false);
            drawn.transform.localScale = new Vector3(side == WingSide.Right ? 1f : -1f, 1f, 1f);
            drawn.AddComponent<MeshFilter>().sharedMesh = WingMesh;
            return new Wing { Renderer = drawn.AddComponent<MeshRenderer>(), Side = side, Skeleton = Skeleton };
        }

        /// <summary>The filter of a wing.</summary>
        protected static MeshFilter Filter(InsectWings insect, int wing) => insect.Wings[wing].Renderer.GetComponent<MeshFilter>();

        /// <summary>Beats since the start, with what there is of the next.</summary>
        protected static float Beats(InsectWings insect)
        {
            WingReading reading = insect.Read(0);
            return reading.Beats + reading.Phase / (2f * math.PI);
        }

        /// <summary>All joints of a wing, wing lengths.</summary>
        protected static float3[] Joints(InsectWings insect, int wing)
        {
            WingReading reading = insect.Read(wing);
            var joints = new float3[reading.ChainCount * reading.JointsPerChain];
            for (int k = 0; k < joints.Length; k++)
                joints[k] = reading.JointPosition(k / reading.JointsPerChain, k % reading.JointsPerChain);
            return joints;
        }

        /// <summary>The largest distance between a joint and the same one.</summary>
        protected static float Farthest(float3[] a, float3[] b)
        {
            float farthest = 0f;
            for (int k = 0; k < a.Length; k++)
                farthest = math.max(farthest, math.distance(a[k], b[k]));
            return farthest;
        }
    }
}
