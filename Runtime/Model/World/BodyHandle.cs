namespace Alate
{
    /// <summary>A flying body of a <see cref="WingWorld"/>.</summary>
    internal readonly struct BodyHandle
    {
        /// <summary>Index among the bodies, and which of those that had it.</summary>
        public readonly int index, version;

        public BodyHandle(int index, int version)
        {
            this.index = index;
            this.version = version;
        }

        /// <summary>True where it names nothing.</summary>
        public bool IsNone => version == 0;
    }
}
