using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Traces the rim of a wing between the centres of pixels: where a field passes through 0 (marching squares).</summary>
    internal static class ContourTracer
    {
        // The sides of a square between the centres of four pixels, clockwise; side k runs from corner k to corner k + 1.
        private const int k_Top = 0, k_Right = 1, k_Bottom = 2, k_Left = 3;

        /// <summary>Longest closed rim, clockwise as seen, without its first point again; pixels, x to the right and y down.</summary>
        public static List<PlanPoint> Longest(PixelPlane field)
        {
            var seen = new HashSet<int>();
            var longest = new List<PlanPoint>();
            for (int row = -1; row < field.height; row++)
            {
                for (int column = -1; column < field.width; column++)
                {
                    // Every rim somewhere runs down with the inside on its left.
                    if (!IsInside(field, column, row) || IsInside(field, column + 1, row) || seen.Contains(Key(field, column, row)))
                        continue;
                    List<PlanPoint> rim = Follow(field, column, row, seen);
                    if (rim.Count > longest.Count)
                        longest = rim;
                }
            }

            return longest;
        }

        private static List<PlanPoint> Follow(PixelPlane field, int column, int row, HashSet<int> seen)
        {
            var rim = new List<PlanPoint>();
            int x = column, y = row, entry = k_Top;
            do
            {
                if (entry == k_Top)
                    seen.Add(Key(field, x, y));
                rim.Add(Crossing(field, x, y, entry));
                int exit = Exit(field, x, y, entry);
                x += exit == k_Right ? 1 : exit == k_Left ? -1 : 0;
                y += exit == k_Bottom ? 1 : exit == k_Top ? -1 : 0;
                entry = (exit + 2) % 4;
            }
            while (x != column || y != row || entry != k_Top);
            return rim;
        }

        // The nearest side on the hand of the outside, so that inner pixels that touch by a corner hang together.
        private static int Exit(PixelPlane field, int x, int y, int entry)
        {
            for (int turn = 1; turn < 4; turn++)
            {
                int side = (entry + turn) % 4;
                if (CornerState(field, x, y, side) != CornerState(field, x, y, (side + 1) % 4))
                    return side;
            }

            throw new InvalidOperationException("A rim cannot end.");
        }

        private static bool CornerState(PixelPlane field, int x, int y, int corner)
        {
            (int cornerX, int cornerY) = Corner(x, y, corner);
            return IsInside(field, cornerX, cornerY);
        }

        private static PlanPoint Crossing(PixelPlane field, int x, int y, int side)
        {
            (int ax, int ay) = Corner(x, y, side);
            (int bx, int by) = Corner(x, y, (side + 1) % 4);
            double a = Value(field, ax, ay), b = Value(field, bx, by), t = a / (a - b);
            return new PlanPoint(ax + t * (bx - ax) + 0.5, ay + t * (by - ay) + 0.5);
        }

        private static (int X, int Y) Corner(int x, int y, int corner) =>
            (corner % 4 == 1 || corner % 4 == 2 ? x + 1 : x, corner % 4 >= 2 ? y + 1 : y);

        private static bool IsInside(PixelPlane field, int column, int row) => Value(field, column, row) > 0f;

        // Around the picture lies ground, so that a wing that runs out of it is closed along its edge.
        private static float Value(PixelPlane field, int column, int row) =>
            column < 0 || row < 0 || column >= field.width || row >= field.height ? -1e-3f : field[column, row];

        private static int Key(PixelPlane field, int column, int row) => (row + 1) * (field.width + 1) + column + 1;
    }
}
