using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>Closes a wing whose base lies beyond the picture, so that cells between veins that run out of it are no ground.</summary>
    internal static class CutWing
    {
        /// <summary>Largest share of a side of the picture over which the cut of a wing reaches.</summary>
        private const double k_LargestCut = 0.9;

        /// <summary>
        /// Set with the stretch of each side closed that lies between the pixels where its largest part reaches the side. A set that
        /// reaches more than two sides is a frame, and stays as it is.
        /// </summary>
        public static PixelMask Closed(PixelMask mask)
        {
            List<PixelPart> parts = mask.Parts();
            if (parts.Count == 0 || parts[0].SidesReached(mask.height) > 2)
                return mask;
            PixelMask wing = parts[0].ToMask(mask.height), closed = mask.Copy();
            Close(wing, closed, mask.width, k => (k, 0));
            Close(wing, closed, mask.width, k => (k, mask.height - 1));
            Close(wing, closed, mask.height, k => (0, k));
            Close(wing, closed, mask.height, k => (mask.width - 1, k));
            return closed;
        }

        private static void Close(PixelMask wing, PixelMask closed, int length, Func<int, (int Column, int Row)> place)
        {
            int first = -1, last = -1;
            for (int k = 0; k < length; k++)
            {
                (int column, int row) = place(k);
                if (!wing[column, row])
                    continue;
                first = first < 0 ? k : first;
                last = k;
            }

            if (first < 0 || last - first >= k_LargestCut * length)
                return;
            for (int k = first; k <= last; k++)
            {
                (int column, int row) = place(k);
                closed[column, row] = true;
            }
        }
    }
}
