using System;

namespace Alate
{
    /// <summary>Moves the inner joints of a chain so that its straight bones do not cut across hollows of the outline.</summary>
    internal static class ChainInset
    {
        private const int k_Rounds = 40;

        /// <summary>Steps in which bones are checked, and how far inside the outline they are brought; wing reaches.</summary>
        private const double k_Step = 0.01;
        private const double k_Clearance = 0.001;

        /// <summary>A joint is moved at most this many times as far as the bone's point that it carries along.</summary>
        private const double k_MostLeverage = 3.0;

        /// <summary>Moves the joints between root and tip.</summary>
        /// <param name="joints">A chain, in place.</param>
        /// <param name="outline">Of the wing.</param>
        public static void Apply(PlanPoint[] joints, ClosedCurve outline)
        {
            var moves = new PlanPoint[joints.Length];
            for (int round = 0; round < k_Rounds; round++)
            {
                Array.Clear(moves, 0, moves.Length);
                bool inside = true;
                for (int j = 0; j + 1 < joints.Length; j++)
                    inside &= Check(joints, j, outline, moves);
                if (inside)
                    return;
                for (int j = 1; j + 1 < joints.Length; j++)
                    joints[j] += moves[j];
            }
        }

        /// <summary>How far a bone strays from the wing.</summary>
        public static double Outside(PlanPoint from, PlanPoint to, ClosedCurve outline)
        {
            double farthest = 0.0;
            int steps = Steps(from, to);
            for (int k = 0; k <= steps; k++)
            {
                PlanPoint p = from + (to - from) * ((double)k / steps);
                if (!outline.Contains(p))
                    farthest = Math.Max(farthest, Math.Sqrt((outline.At(outline.Nearest(p)) - p).LengthSquared));
            }

            return farthest;
        }

        private static bool Check(PlanPoint[] joints, int bone, ClosedCurve outline, PlanPoint[] moves)
        {
            PlanPoint from = joints[bone], to = joints[bone + 1];
            bool inside = true;
            int steps = Steps(from, to);
            for (int k = 1; k < steps; k++)
            {
                double share = (double)k / steps;
                PlanPoint p = from + (to - from) * share;
                if (outline.Contains(p))
                    continue;
                PlanPoint off = outline.At(outline.Nearest(p)) - p;
                double distance = Math.Sqrt(off.LengthSquared);
                if (distance < k_Clearance)
                    continue;
                inside = false;
                PlanPoint push = off * ((distance + k_Clearance) / distance);
                Push(moves, bone, joints.Length, 1.0 - share, push);
                Push(moves, bone + 1, joints.Length, share, push);
            }

            return inside;
        }

        // The largest push on a joint counts; root and tip stay, so that the other end of their bone has to do it all.
        private static void Push(PlanPoint[] moves, int joint, int count, double share, PlanPoint push)
        {
            if (joint == 0 || joint == count - 1 || share <= 0.0)
                return;
            bool otherIsFixed = joint == 1 || joint == count - 2;
            PlanPoint move = push * (otherIsFixed ? Math.Min(1.0 / share, k_MostLeverage) : 1.0) * Math.Min(2.0 * share, 1.0);
            if (move.LengthSquared > moves[joint].LengthSquared)
                moves[joint] = move;
        }

        private static int Steps(PlanPoint from, PlanPoint to) =>
            Math.Max(2, (int)Math.Ceiling(Math.Sqrt((to - from).LengthSquared) / k_Step));
    }
}
