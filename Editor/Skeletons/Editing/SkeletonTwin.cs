using UnityEngine;

namespace Alate.Editor
{
    /// <summary>The skeleton of the wing on the other side, which symmetric editing keeps in step.</summary>
    internal sealed class SkeletonTwin
    {
        /// <param name="skeleton">The twin; not the edited skeleton itself.</param>
        /// <param name="toTwin">From the edited skeleton's mesh space to the twin's; a mirror image.</param>
        public SkeletonTwin(WingSkeleton skeleton, Matrix4x4 toTwin)
        {
            Skeleton = skeleton;
            ToTwin = toTwin;
        }

        public WingSkeleton Skeleton { get; }

        public Matrix4x4 ToTwin { get; }

        /// <summary>Reason why the twin may not be changed, one sentence; null where it may.</summary>
        public string Lock { get; set; }

        /// <summary>
        /// Proposes the twin's content when a command turns its start into another draft. Joints that the command does not move keep their
        /// own place in the twin; where it changes the counts, the twin's chains become the mirror image.
        /// </summary>
        public Proposal Follow(in EditStart start, SkeletonDraft after)
        {
            if (Lock != null)
                return Proposal.Refuse(Lock);
            SkeletonDraft before = start.Own, twin = start.Twin;
            bool alike = before != null && twin != null
                && twin.ChainCount == before.ChainCount && twin.JointsPerChain == before.JointsPerChain;
            if (!alike)
            {
                return Proposal.Refuse(
                    $"Symmetric editing: '{Skeleton.name}' has other counts. Mirror onto it first, or turn symmetry off.");
            }

            SkeletonDraft image = SkeletonMirror.Reflect(after, ToTwin);
            bool sameCounts = after.ChainCount == before.ChainCount && after.JointsPerChain == before.JointsPerChain;
            SkeletonDraft next = (sameCounts ? twin : image).Copy();
            for (int i = 0; sameCounts && i < after.ChainCount; i++)
            {
                if (!after.IsMeasuredAs(before, i))
                    next.SetChain(i, next.Chain(i), after.Measured(i));
                for (int j = 0; j < after.JointsPerChain; j++)
                {
                    if (!after[i, j].Equals(before[i, j]))
                        next[i, j] = image[i, j];
                }
            }

            next.Hinge = after.Hinge.Equals(before.Hinge) ? twin.Hinge : image.Hinge;
            next.SpanAxis = after.SpanAxis.Equals(before.SpanAxis) ? twin.SpanAxis : image.SpanAxis;
            next.UpAxis = after.UpAxis.Equals(before.UpAxis) ? twin.UpAxis : image.UpAxis;
            return Proposal.Make(next);
        }
    }
}
