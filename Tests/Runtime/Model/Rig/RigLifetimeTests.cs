using System;
using NUnit.Framework;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
using Unity.Collections;
#endif

namespace Alate.Tests
{
    public sealed class RigLifetimeTests
    {
        [Test]
        public void ABakedRig_HasOneUser()
        {
            WingRig rig = TestWings.Rig();
            Assert.That(rig.IsDisposed, Is.False);

            rig.Release();
            Assert.That(rig.IsDisposed, Is.True);
        }

        [Test]
        public void ARig_LivesUntilItsLastUserIsGone()
        {
            WingRig rig = TestWings.Rig();
            rig.Retain();
            rig.Retain();
            rig.Release();
            rig.Release();
            Assert.That(rig.IsDisposed, Is.False);
            Assert.That(rig.JointMasses[0], Is.GreaterThan(0f));

            rig.Release();
            Assert.That(rig.IsDisposed, Is.True);
        }

        [Test]
        public void AfterItsLastUser_ARigCanDoNothing()
        {
            WingRig rig = TestWings.Rig();
            rig.Release();

            Assert.Throws<ObjectDisposedException>(rig.Release);
            Assert.Throws<ObjectDisposedException>(rig.Retain);
            Assert.Throws<ObjectDisposedException>(() => _ = rig.JointCount);
            Assert.Throws<ObjectDisposedException>(() => _ = rig.RestJoints);
            Assert.That(rig.Frame.length, Is.EqualTo(1f));
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        [Test]
        public void DisposingARig_FreesItsArrays()
        {
            WingRig rig = TestWings.Rig();
            NativeArray<float>.ReadOnly masses = rig.JointMasses;
            NativeArray<int>.ReadOnly vertices = rig.JointVertices;
            rig.Release();

            Assert.That(() => masses[0], Throws.InstanceOf<InvalidOperationException>());
            Assert.That(() => vertices[0], Throws.InstanceOf<InvalidOperationException>());
        }
#endif
    }
}
