namespace Alate.Editor
{
    /// <summary>What a skeleton and its twin were when an act or a drag began.</summary>
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
