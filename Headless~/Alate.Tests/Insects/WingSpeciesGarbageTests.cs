using System;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingSpeciesGarbageTests
    {
        [Test]
        public void TurningASpeciesIntoParameters_AllocatesNothing()
        {
            var species = Species.Monarch();
            species.ToParameters();

            var before = GC.GetAllocatedBytesForCurrentThread();
            for (var i = 0; i < 100; i++)
            {
                species.ToParameters();
            }

            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.EqualTo(0));
            UnityEngine.Object.DestroyImmediate(species);
        }
    }
}
