using System.Collections.Generic;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Bakes rigs for a test and releases them after it.</summary>
    public abstract class RigFixture
    {
        private readonly List<WingRig> m_Rigs = new List<WingRig>();

        [TearDown]
        public void ReleaseRigs()
        {
            foreach (WingRig rig in m_Rigs)
                rig.Release();
            m_Rigs.Clear();
        }

        /// <summary>The elliptical wing and its fan.</summary>
        protected WingRig Bake(int patchCount = 0) => Bake(TestWings.Fan(), TestWings.Ellipse(), patchCount);

        protected WingRig Bake(WingSkeleton skeleton, SurfaceMesh surface, int patchCount = 0) =>
            Keep(TestWings.Bake(skeleton, surface, patchCount));

        /// <summary>Releases this one too.</summary>
        protected WingRig Keep(WingRig rig)
        {
            m_Rigs.Add(rig);
            return rig;
        }
    }
}
