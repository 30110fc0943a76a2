using System;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>Moves the inner joints of a chain so that its straight bones do not cut across hollows of the outline.</summary>
    internal static class ChainInset
    {
        private const int k_Rounds = 40;

        /// <summary>
        /// Steps in which bones are checked, tolerated distance outside the wing, and the distance that a correction aims at; wing reaches.
        /// </summary>
        private const double k_Step = 0.01;
        private const double k_Unminded = 0.004;
        private const double k_Left = 0.003;

        /// <summary>Largest movement of a joint over that of the bone's point that it carries along.</summary>
        private const double k_MostLeverage = 3.0;

        /// <summary>Moves the joints between root and tip.</summary>
        /// <param name="joints">A chain, in place.</param>
        /// <param name="outline">Of the wing.</param>
        public static void Apply(PlanPoint[] joints, ClosedCurve outline)
        {
            var moves = new PlanPoint[joints.Length];
            var best = (PlanPoint[])joints.Clone();
            double least = double.MaxValue;
            for (int round = 0; round < k_Rounds && least > k_Unminded; round++)
            {
                Array.Clear(moves, 0, moves.Length);
                double outside = Check(joints, outline, moves);
                if (outside < least)
                {
                    least = outside;
                    joints.CopyTo(best, 0);
                }

                for (int j = 1; j + 1 < joints.Length; j++)
                    joints[j] += moves[j];
            }

            best.CopyTo(joints, 0);
        }

        /// <summary>Largest distance of the bones of a chain outside the wing.</summary>
        public static double Outside(PlanPoint[] joints, ClosedCurve outline) => Check(joints, outline, new PlanPoint[joints.Length]);

        private static double Check(PlanPoint[] joints, ClosedCurve outline, PlanPoint[] moves)
        {
            double outside = 0.0;
            for (int j = 0; j + 1 < joints.Length; j++)
                outside = Math.Max(outside, Check(joints, j, outline, moves));
            return outside;
        }

        // How far the bone strays, and how its joints should move.
        private static double Check(PlanPoint[] joints, int bone, ClosedCurve outline, PlanPoint[] moves)
        {
            PlanPoint from = joints[bone], to = joints[bone + 1];
            double farthest = 0.0;
            int steps = Steps(from, to);
            for (int k = 1; k < steps; k++)
            {
                double share = (double)k / steps;
                PlanPoint p = from + (to - from) * share;
                if (outline.Contains(p))
                    continue;
                PlanPoint off = outline.At(outline.Nearest(p)) - p;
                double distance = Math.Sqrt(off.LengthSquared);
                farthest = Math.Max(farthest, distance);
                if (distance <= k_Unminded)
                    continue;
                PlanPoint push = off * ((distance - k_Left) / distance);
                Split(joints.Length, bone, share, out double inner, out double outer);
                Push(moves, bone, push * inner);
                Push(moves, bone + 1, push * outer);
            }

            return farthest;
        }

        // The least moves of both joints that move the bone's point by 1; root and tip stay.
        private static void Split(int count, int bone, double share, out double inner, out double outer)
        {
            double first = bone == 0 ? 0.0 : 1.0 - share, second = bone + 1 == count - 1 ? 0.0 : share;
            double squares = Math.Max(first * first + second * second, 1.0 / (k_MostLeverage * k_MostLeverage));
            inner = first / squares;
            outer = second / squares;
        }

        // The largest push on a joint counts.
        private static void Push(PlanPoint[] moves, int joint, PlanPoint move)
        {
            if (move.LengthSquared > moves[joint].LengthSquared)
                moves[joint] = move;
        }

        private static int Steps(PlanPoint from, PlanPoint to) =>
            Math.Max(2, (int)Math.Ceiling(Math.Sqrt((to - from).LengthSquared) / k_Step));
    }
}
