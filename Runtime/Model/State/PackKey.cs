using System;

namespace Alate
{
    /// <summary>Clock and level of detail of a wing. Wings share a pack only where both are equal.</summary>
    internal readonly struct PackKey : IEquatable<PackKey>
    {
        /// <summary>Clock of the wing.</summary>
        public readonly ClockId clock;

        /// <summary>Owner of a clock of its own, so that wings of one insect stay together; 0 for the other clocks.</summary>
        public readonly int owner;

        /// <summary>The level of detail.</summary>
        public readonly WingDetail detail;

        public PackKey(ClockId clock, int owner, WingDetail detail)
        {
            this.clock = clock;
            this.owner = clock == ClockId.Own ? owner : 0;
            this.detail = detail;
        }

        public bool Equals(PackKey other) => clock == other.clock && owner == other.owner && detail == other.detail;

        public override bool Equals(object other) => other is PackKey pacing && Equals(pacing);

        public override int GetHashCode() => (owner * 8 + (int)clock) * 8 + (int)detail;
    }
}
