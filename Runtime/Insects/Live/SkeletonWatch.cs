namespace Alate
{
    /// <summary>Skeletons in use, read once a frame.</summary>
    internal sealed class SkeletonWatch : AssetWatch<WingSkeleton, SkeletonValue>
    {
        public SkeletonWatch()
            : base(new SkeletonValue(null))
        {
        }

        protected override SkeletonValue Read(WingSkeleton skeleton) => new SkeletonValue(skeleton);
    }
}
