using System;

namespace Alate
{
    /// <summary>When a wing is stepped, and with how much detail. Wings share a pack only where both are the same.</summary>
    internal readonly struct PackKey : IEquatable<PackKey>
    {
        /// <summary>Whose time the wing keeps.</summary>
        public readonly ClockId clock;

        /// <summary>With a clock of its own: whose, so that wings of one insect stay together. Otherwise 0.</summary>
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
