namespace Alate.Editor
{
    /// <summary>State of a skeleton and its twin at the beginning of a command or a drag.</summary>
    internal readonly struct EditStart
    {
        public EditStart(SkeletonDraft own, SkeletonDraft twin)
        {
            Own = own;
            Twin = twin;
        }

        /// <summary>The skeleton; null where its chains were not complete.</summary>
        public SkeletonDraft Own { get; }

        /// <summary>The twin; null where there is none or its chains were not complete.</summary>
        public SkeletonDraft Twin { get; }
    }
}
