using System;

namespace Alate.Tests
{
    /// <summary>A world with one monarch wing in level flight.</summary>
    internal sealed class FlownMonarch : IDisposable
    {
        public readonly WingWorld world = new WingWorld();
        public readonly WingHandle wing;

        public FlownMonarch(float speed = 1.3f, float pitch = 0f)
            : this(Monarch.Parameters, speed, pitch)
        {
        }

        public FlownMonarch(in WingParameters parameters, float speed = 1.3f, float pitch = 0f)
        {
            WingRig rig = Monarch.Rig();
            wing = world.Add(rig, parameters, Monarch.Flying(speed, pitch));
            rig.Release();
        }

        public WingReading Reading => world.Read(wing);

        /// <summary>One of 24 substeps of a beat, seconds.</summary>
        public float Substep => 1f / (24f * Reading.Frequency);

        public void Dispose() => world.Dispose();
    }
}
