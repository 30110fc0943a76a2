using System;
using System.Collections.Generic;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class GarbageTests
    {
        [TestCase(1)]
        [TestCase(10)]
        [TestCase(100, Explicit = true, Category = "Long")]
        public void SteppingAndSkinning_AllocatesNothing_HoweverManyInsects(int insects)
        {
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                var wings = new List<WingHandle>();
                for (int k = 0; k < 2 * insects; k++)
                    wings.Add(world.Add(rig, Monarch.Parameters, Monarch.Flying()));
                rig.Release();
                Frame(world, wings);
                // The least of some rounds: threads of the test runner allocate now and then.
                long least = long.MaxValue;
                for (int round = 0; round < 25; round++)
                {
                    long before = GC.GetTotalAllocatedBytes(true);
                    Frame(world, wings);
                    Frame(world, wings);
                    least = Math.Min(least, GC.GetTotalAllocatedBytes(true) - before);
                }

                Assert.That(least, Is.Zero);
                long jobs = world.JobCount;
                Frame(world, wings);
                Assert.That(world.JobCount - jobs, Is.EqualTo(2), "one step job and one skinning job, however many wings");
            }
        }

        private static void Frame(WingWorld world, List<WingHandle> wings)
        {
            for (int k = 0; k < wings.Count; k++)
                world.SetSurroundings(wings[k], Monarch.Flying(1.2f));
            world.Step(0.02f);
            world.Skin(0.5f);
            _ = world.Bounds(wings[0]);
            _ = world.Read(wings[0]).JointPosition(0, 4);
        }
    }
}
