using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>A monarch in the scene with two wings, each with its own mesh and skeleton, on a body that is turned and scaled.</summary>
    public abstract class SkeletonSessionFixture
    {
        private readonly List<Object> m_Made = new List<Object>();

        private protected InsectWings Insect { get; private set; }

        private protected Wing Right { get; private set; }

        private protected Wing Left { get; private set; }

        [SetUp]
        public void Build()
        {
            Insect = Keep(new GameObject("Monarch")).AddComponent<InsectWings>();
            Insect.transform.SetPositionAndRotation(new Vector3(3f, 1f, -2f), Quaternion.Euler(20f, 70f, -15f));
            Insect.transform.localScale = 2f * Vector3.one;
            Right = MakeWing(WingSide.Right);
            Left = MakeWing(WingSide.Left);
            Insect.Wings.Clear();
            Insect.Wings.Add(Right);
            Insect.Wings.Add(Left);
        }

        [TearDown]
        public void Clear()
        {
            using (var fresh = new SkeletonSession(new SkeletonTarget[0], new SnapshotUndo()))
                SkeletonSettings.Keep(fresh);
            foreach (Object made in m_Made)
                Object.DestroyImmediate(made);
            m_Made.Clear();
        }

        private protected T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        private Wing MakeWing(WingSide side)
        {
            WingDefinition monarch = InsectCatalogue.Find("monarch").Wings[0];
            var holder = new GameObject($"{side} Wing", typeof(MeshFilter), typeof(MeshRenderer));
            holder.transform.SetParent(Insect.transform, false);
            holder.transform.localPosition = monarch.HingeOn(side);
            holder.GetComponent<MeshFilter>().sharedMesh = Keep(monarch.CreateSurface(side).ToMesh($"{side} wing"));
            WingSkeleton skeleton = Keep(monarch.CreateSkeleton(side));
            skeleton.name = $"{side} Wing";
            return new Wing { Renderer = holder.GetComponent<MeshRenderer>(), Side = side, Skeleton = skeleton };
        }
    }
}
