using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Commands that set the hinge and the axes of the wing.</summary>
    internal static class FrameCommands
    {
        /// <summary>Puts the hinge at the middle of the selected joints; at the first root where none is selected.</summary>
        public static Proposal SetHinge(SkeletonDraft draft, JointIndex[] selected)
        {
            SkeletonDraft next = draft.Copy();
            next.Hinge = selected.Length == 0 ? draft[0, 0] : Middle(draft, selected);
            return Proposal.Make(next);
        }

        /// <summary>
        /// Turns the span axis from the hinge to the middle of the selected joints; to the principal chain's tip where none is selected.
        /// </summary>
        public static Proposal SetSpan(SkeletonDraft draft, JointIndex[] selected)
        {
            Vector3 target = selected.Length == 0 ? draft[0, draft.JointsPerChain - 1] : Middle(draft, selected);
            return WithAxes(draft, target - draft.Hinge, draft.UpAxis);
        }

        /// <summary>
        /// Fits both axes to the joints: span from the hinge to the principal chain's tip, up along the normal of the plane through the
        /// joints, on its present side.
        /// </summary>
        public static Proposal FitAxes(SkeletonDraft draft)
        {
            Vector3 up = Normal(draft);
            if (Vector3.Dot(up, draft.UpAxis) < 0f)
                up = -up;
            return WithAxes(draft, draft[0, draft.JointsPerChain - 1] - draft.Hinge, up);
        }

        /// <summary>Turns the upper side down.</summary>
        public static Proposal FlipUp(SkeletonDraft draft) => WithAxes(draft, draft.SpanAxis, -draft.UpAxis);

        private static Proposal WithAxes(SkeletonDraft draft, Vector3 span, Vector3 up)
        {
            if (!WingAxes.TryMake(span, up, out float3x3 _))
                return Proposal.Refuse("Span and up axis would be zero or parallel.");
            SkeletonDraft next = draft.Copy();
            next.SpanAxis = Unit(span);
            next.UpAxis = Unit(up);
            return Proposal.Make(next);
        }

        // The sum of the areas of all cells: for a bent wing the plane of the most area.
        private static Vector3 Normal(SkeletonDraft draft)
        {
            Vector3 sum = Vector3.zero;
            for (int i = 0; i + 1 < draft.ChainCount; i++)
            {
                for (int j = 0; j + 1 < draft.JointsPerChain; j++)
                    sum += Vector3.Cross(draft[i + 1, j + 1] - draft[i, j], draft[i + 1, j] - draft[i, j + 1]);
            }

            return sum;
        }

        private static Vector3 Middle(SkeletonDraft draft, JointIndex[] selected)
        {
            Vector3 sum = Vector3.zero;
            foreach (JointIndex joint in selected)
                sum += draft[joint] / selected.Length;
            return sum;
        }

        // Scaled first: Vector3.normalized gives zero for short vectors.
        private static Vector3 Unit(Vector3 v) => (Vector3)math.normalize((float3)v / math.cmax(math.abs((float3)v)));
    }
}
