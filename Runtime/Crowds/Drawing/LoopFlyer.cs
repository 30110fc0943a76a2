using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>Lets a live insect beat as a loop of its baked twin was flown.</summary>
    internal sealed class LoopFlyer : IFlyingInsect
    {
        /// <summary>The loop, and the factor on its frequency.</summary>
        public CrowdLoop loop;

        /// <inheritdoc cref="loop"/>
        public float rate = 1f;

        /// <inheritdoc/>
        public void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float length, int count)
        {
            float pitch = live.Pitch;
            for (int k = 0; k < live.wings.Length; k++)
            {
                LiveWing wing = live.wings[k];
                if (wing.placed.isValid)
                    world.TrySetSurroundings(wing.handle, wing.Surroundings(live.flight, pitch));
                Drive(world, wing, live.insect.Wings[k].Side);
            }
        }

        /// <inheritdoc/>
        public void Show(LiveInsect live, WingWorld world, float alpha)
        {
        }

        private void Drive(WingWorld world, LiveWing wing, WingSide side)
        {
            if (!loop.isFlown)
            {
                if (loop.steering.fold > 0f)
                    world.SetDrive(wing.handle, wing.values.Folded(loop.steering.fold));
                else
                    world.ReleaseDrive(wing.handle);
                return;
            }

            WingDrive drive = side == WingSide.Left ? loop.leftBeat : loop.rightBeat;
            drive.frequency = NumberRange.Clamp(drive.frequency * rate, WingDrive.LeastFrequency, WingDrive.MostFrequency, drive.frequency);
            world.SetDrive(wing.handle, drive);
        }
    }
}
