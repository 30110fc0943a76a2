using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>Numbers by which insects tell that a skeleton was edited.</summary>
    public sealed class SkeletonValueLaws
    {
        private WingSkeleton m_Skeleton;

        [SetUp]
        public void Make() => m_Skeleton = TestWings.Fan();

        [TearDown]
        public void End() => Object.DestroyImmediate(m_Skeleton);

        [Test]
        public void AnyEdit_GivesAnotherNumber_AndTakenBack_TheOldOne()
        {
            var value = new SkeletonValue(m_Skeleton);
            uint before = value.Hash;
            var seen = new HashSet<uint> { before };
            for (int axis = 0; axis < 3; axis++)
            {
                Try(() => m_Skeleton.Hinge, place => m_Skeleton.Hinge = place, axis);
                Try(() => m_Skeleton.SpanAxis, place => m_Skeleton.SpanAxis = place, axis);
                Try(() => m_Skeleton.UpAxis, place => m_Skeleton.UpAxis = place, axis);
                for (int chain = 0; chain < m_Skeleton.ChainCount; chain++)
                {
                    for (int joint = 0; joint < m_Skeleton.JointsPerChain; joint++)
                    {
                        Vector3[] joints = m_Skeleton.Chains[chain].joints;
                        int at = joint;
                        Try(() => joints[at], place => joints[at] = place, axis);
                    }
                }
            }

            JointChain[] chains = m_Skeleton.Chains, kept = (JointChain[])chains.Clone();
            float[] values = new[] { 0.25f, 0.5f, 0.75f };
            foreach (Action edit in new Action[]
            {
                () => chains[1].flexuralStiffness = values, () => chains[1].torsionalStiffness = values,
                () => chains[1].veinWidths = values, () => chains[2].veinWidths = values,
                () => chains[1].flexuralStiffness = new[] { 0.5f, 0.25f, 0.75f }, () => (chains[1], chains[2]) = (chains[2], chains[1]),
                () => m_Skeleton.Chains = new[] { kept[0], kept[1], kept[2] },
            })
            {
                edit();
                value.Refresh();
                Assert.That(seen.Add(value.Hash));
                m_Skeleton.Chains = chains = (JointChain[])kept.Clone();
                value.Refresh();
                Assert.That(value.Hash, Is.EqualTo(before));
            }

            Assert.That(new SkeletonValue(m_Skeleton).Hash, Is.EqualTo(before), "equal content");
            Assert.That(new SkeletonValue(null).Hash, Is.Zero);
            void Try(Func<Vector3> get, Action<Vector3> set, int axis)
            {
                Vector3 old = get(), edited = old;
                edited[axis] += 0.125f;
                set(edited);
                value.Refresh();
                Assert.That(seen.Add(value.Hash));
                set(old);
                value.Refresh();
                Assert.That(value.Hash, Is.EqualTo(before));
            }
        }
    }
}
