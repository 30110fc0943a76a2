using System;

namespace Alate
{
    /// <summary>Clock and level of detail of a wing. Wings share a pack only where both are equal.</summary>
    internal readonly struct PackKey : IEquatable<PackKey>
    {
        /// <summary>Clock of the wing.</summary>
        public readonly WingUpdateMode clock;

        /// <summary>Stepped by hand: whose, so that wings of one insect stay together. Otherwise 0.</summary>
        public readonly int owner;

        /// <summary>The level of detail.</summary>
        public readonly WingDetail detail;

        public PackKey(WingUpdateMode clock, int owner, WingDetail detail)
        {
            this.clock = clock;
            this.owner = clock == WingUpdateMode.Manual ? owner : 0;
            this.detail = detail;
        }

        public bool Equals(PackKey other) => clock == other.clock && owner == other.owner && detail == other.detail;

        public override bool Equals(object other) => other is PackKey key && Equals(key);

        public override int GetHashCode() => (owner * 8 + (int)clock) * 8 + (int)detail;
    }
}
