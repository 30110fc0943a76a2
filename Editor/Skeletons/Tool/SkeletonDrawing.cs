using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws skeletons with handles of a constant size on the screen.</summary>
    internal static class SkeletonDrawing
    {
        private const float k_JointSize = 0.045f;
        private const float k_RingSize = 0.1f;
        private const float k_AxisLength = 0.8f;
        private const float k_BoneWidth = 3f;

        /// <summary>Bones, joints, hinge, axes and labels of one skeleton; for repaint events.</summary>
        /// <param name="editing">The skeleton.</param>
        /// <param name="isActive">Whether it is the active one; others are drawn paler.</param>
        /// <param name="labels">Whether joints are numbered.</param>
        /// <param name="hovered">The joint that a click would mean; null where it means none of this skeleton.</param>
        public static void Draw(SkeletonEditing editing, bool isActive, bool labels, JointIndex? hovered)
        {
            WingSkeleton skeleton = editing.Skeleton;
            Matrix4x4 place = editing.LocalToWorld;
            float strength = isActive ? 1f : 0.5f;
            DrawBones(skeleton, place, strength);
            foreach (JointIndex joint in JointPicking.All(skeleton))
            {
                if (!IsSomewhere(skeleton, joint))
                    continue;
                bool isHovered = hovered.HasValue && hovered.Value == joint;
                Color colour = editing.Selection.Contains(joint) ? SkeletonColours.selected
                    : isHovered ? SkeletonColours.hovered
                    : SkeletonColours.joint;
                Dot(place.MultiplyPoint3x4(skeleton.GetJoint(joint.chain, joint.joint)), colour * strength, isHovered ? 1.5f : 1f);
            }

            DrawFrame(skeleton, place);
            if (isActive)
                DrawProblems(skeleton, place);
            if (labels && isActive)
                DrawLabels(skeleton, place);
        }

        /// <summary>A ring around a place of the world, such as where a rig is weak.</summary>
        public static void Ring(Vector3 place, Color colour)
        {
            Handles.color = colour;
            Vector3 facing = Camera.current == null ? Vector3.up : Camera.current.transform.forward;
            Handles.DrawWireDisc(place, facing, k_RingSize * HandleUtility.GetHandleSize(place), 2f);
        }

        private static void DrawBones(WingSkeleton skeleton, Matrix4x4 place, float strength)
        {
            var previous = new Vector3[0];
            for (int i = 0; i < skeleton.ChainCount; i++)
            {
                // A joint that is nowhere is left out of its chain.
                Vector3[] joints = System.Array.FindAll(skeleton.Chains[i].joints ?? new Vector3[0], SkeletonDraft.IsUsable);
                Vector3[] line = System.Array.ConvertAll(joints, joint => place.MultiplyPoint3x4(joint));
                Handles.color = (i == 0 ? SkeletonColours.principalChain : SkeletonColours.chain) * strength;
                if (line.Length > 1)
                    Handles.DrawAAPolyLine(k_BoneWidth, line);
                Handles.color = SkeletonColours.row * strength;
                for (int j = 0; j < line.Length && j < previous.Length; j++)
                    Handles.DrawLine(previous[j], line[j]);
                previous = line;
            }
        }

        private static void DrawFrame(WingSkeleton skeleton, Matrix4x4 place)
        {
            if (!SkeletonDraft.IsUsable(skeleton.Hinge))
                return;
            Vector3 hinge = place.MultiplyPoint3x4(skeleton.Hinge);
            float size = k_AxisLength * HandleUtility.GetHandleSize(hinge);
            Ring(hinge, SkeletonColours.hinge);
            if (!WingAxes.TryMake(skeleton.SpanAxis, skeleton.UpAxis, out float3x3 axes))
                return;
            Arrow(hinge, place.MultiplyVector(axes.c0), size, Handles.xAxisColor);
            Arrow(hinge, place.MultiplyVector(axes.c1), size, Handles.yAxisColor);
        }

        private static void DrawProblems(WingSkeleton skeleton, Matrix4x4 place)
        {
            foreach (SkeletonProblem problem in skeleton.Validate())
            {
                var joint = new JointIndex(problem.Chain, math.max(problem.Joint, 0));
                if (IsSomewhere(skeleton, joint))
                    Ring(place.MultiplyPoint3x4(skeleton.GetJoint(joint.chain, joint.joint)), SkeletonColours.problem);
            }
        }

        // Chains at their tips, joints along the principal chain: every joint's numbers can be read off, and nothing is hidden.
        private static void DrawLabels(WingSkeleton skeleton, Matrix4x4 place)
        {
            for (int i = 0; i < skeleton.ChainCount; i++)
                Label(skeleton, place, new JointIndex(i, skeleton.Chains[i].Length - 1), $"  chain {i}");

            for (int j = 0; j < skeleton.JointsPerChain - 1; j++)
                Label(skeleton, place, new JointIndex(0, j), $"  {j}");
            if (SkeletonDraft.IsUsable(skeleton.Hinge))
                Handles.Label(place.MultiplyPoint3x4(skeleton.Hinge), "\n  hinge", EditorStyles.whiteMiniLabel);
        }

        private static void Label(WingSkeleton skeleton, Matrix4x4 place, JointIndex joint, string text)
        {
            if (IsSomewhere(skeleton, joint))
                Handles.Label(place.MultiplyPoint3x4(skeleton.GetJoint(joint.chain, joint.joint)), text, EditorStyles.whiteMiniLabel);
        }

        private static bool IsSomewhere(WingSkeleton skeleton, JointIndex joint) =>
            joint.IsIn(skeleton) && SkeletonDraft.IsUsable(skeleton.GetJoint(joint.chain, joint.joint));

        private static void Dot(Vector3 place, Color colour, float scale)
        {
            Handles.color = colour;
            Handles.DotHandleCap(
                0, place, Quaternion.identity, scale * k_JointSize * HandleUtility.GetHandleSize(place), EventType.Repaint);
        }

        private static void Arrow(Vector3 place, Vector3 direction, float size, Color colour)
        {
            if (direction.sqrMagnitude <= 0f)
                return;
            Handles.color = colour;
            Handles.ArrowHandleCap(0, place, Quaternion.LookRotation(direction), size, EventType.Repaint);
        }
    }
}
