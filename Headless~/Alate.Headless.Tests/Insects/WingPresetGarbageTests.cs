using System;
using Alate.Catalogue;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class WingPresetGarbageTests
    {
        [Test]
        public void TurningASpeciesIntoParameters_AllocatesNothing()
        {
            WingPreset preset = InsectCatalogue.Monarch();
            preset.ToParameters();

            // The least of some rounds: the runtime itself may allocate once in between.
            long least = long.MaxValue;
            for (int round = 0; round < 5; round++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 100; i++)
                    preset.ToParameters();
                least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
            }

            Assert.That(least, Is.Zero);
            UnityEngine.Object.DestroyImmediate(preset);
        }
    }
}
