using NUnit.Framework;
using StandIns;

namespace Alate.Tests
{
    public sealed class TrackedMemoryTests
    {
        [Test]
        public void EveryBlockOfAWorld_IsSeenByUnitysLeakDetection()
        {
            int live = NativeMemoryLedger.LiveCount, unseen = NativeMemoryLedger.UntrackedCount;
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.Parameters, Monarch.Flying());
                rig.Release();
                world.RecordPatches(wing, true);
                world.Step(0.02f);
                world.Skin(0.5f);

                Assert.That(NativeMemoryLedger.LiveCount, Is.GreaterThan(live));
                Assert.That(NativeMemoryLedger.UntrackedCount, Is.EqualTo(unseen), NativeMemoryLedger.Describe());
            }

            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(live), NativeMemoryLedger.Describe());
        }
    }
}
