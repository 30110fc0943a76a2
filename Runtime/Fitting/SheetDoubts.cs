using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>Warns where the shape of a sheet makes a skeleton doubtful.</summary>
    internal static class SheetDoubts
    {
        /// <summary>Area of a hole, over the wing's, from which it causes a warning.</summary>
        private const double k_Hole = 1e-3;

        /// <summary>Area seen from above over that in space below which a wing is strongly curved.</summary>
        private const double k_Curved = 0.85;

        /// <summary>Area within the outline over that of the triangles seen from above, below which some lie over others.</summary>
        private const double k_Folded = 0.985;

        public static void Warn(WingSheet sheet, FitNotes notes)
        {
            double holes = 0.0, largest = 0.0;
            int count = 0;
            foreach (List<int> hole in sheet.holes)
            {
                double area = Math.Abs(Polygon.Area(sheet.Seen(hole)));
                holes += area;
                count += area > k_Hole * sheet.PlanArea ? 1 : 0;
                largest = Math.Max(largest, area);
            }

            if (count > 0)
            {
                string many = count == 1 ? "a hole" : $"{count} holes";
                notes.Warn(
                    SkeletonFitWarningKind.Holes, 0.95,
                    $"The wing has {many}, the largest of {FitNotes.Percent(largest / sheet.PlanArea, "0.#")} of its area; chains run as "
                    + "if there were none.");
            }

            double flat = sheet.PlanArea / sheet.Area;
            if (flat < k_Curved)
            {
                notes.Warn(
                    SkeletonFitWarningKind.StronglyCurved, flat / k_Curved,
                    $"The wing is strongly curved: from above only {FitNotes.Percent(flat, "0.#")} of its area is seen.");
            }

            double folded = sheet.OutlineShare - holes / sheet.PlanArea;
            if (folded < k_Folded)
            {
                notes.Warn(
                    SkeletonFitWarningKind.FoldsOverItself, Math.Max(folded, 0.0),
                    $"The wing folds over itself: from above {FitNotes.Percent(1.0 - folded, "0.#")} of its area lies over other parts.");
            }
        }
    }
}
