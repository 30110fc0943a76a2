using System;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Names one wing of a <see cref="WingWorld"/>; invalid once the wing is removed.</summary>
    [MovedFrom(true, null, "Alate")]
    public readonly struct WingHandle : IEquatable<WingHandle>
    {
        internal readonly int index;
        internal readonly int version;

        internal WingHandle(int index, int version)
        {
            this.index = index;
            this.version = version;
        }

        /// <summary>True for the default value, which names no wing.</summary>
        public bool IsNone => version == 0;

        /// <inheritdoc/>
        public bool Equals(WingHandle other) => index == other.index && version == other.version;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is WingHandle handle && Equals(handle);

        /// <inheritdoc/>
        public override int GetHashCode() => index * 397 ^ version;

        /// <inheritdoc/>
        public override string ToString() => IsNone ? "no wing" : $"wing {index} (version {version})";
    }
}
