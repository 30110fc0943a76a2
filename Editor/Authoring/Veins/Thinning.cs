using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>Thins a set of pixels to connected lines of single pixels (Guo and Hall, 1989).</summary>
    internal static class Thinning
    {
        public static PixelMask Run(PixelMask mask)
        {
            PixelMask thin = mask.Copy();
            var left = new List<int>();
            for (int k = 0; k < mask.width * mask.height; k++)
            {
                if (mask[k % mask.width, k / mask.width])
                    left.Add(k);
            }

            // A round without a change in either of its halves ends it.
            for (int still = 0, half = 0; still < 2; half = 1 - half)
            {
                var gone = new HashSet<int>();
                foreach (int k in left)
                {
                    if (CanGo(thin, k % mask.width, k / mask.width, half == 0))
                        gone.Add(k);
                }

                foreach (int k in gone)
                    thin[k % mask.width, k / mask.width] = false;
                left.RemoveAll(gone.Contains);
                still = gone.Count == 0 ? still + 1 : 0;
            }

            return thin;
        }

        private static bool CanGo(PixelMask thin, int x, int y, bool first)
        {
            // The eight neighbours clockwise from the one above.
            bool n = thin.Contains(x, y - 1), ne = thin.Contains(x + 1, y - 1), e = thin.Contains(x + 1, y),
                se = thin.Contains(x + 1, y + 1);
            bool s = thin.Contains(x, y + 1), sw = thin.Contains(x - 1, y + 1), w = thin.Contains(x - 1, y),
                nw = thin.Contains(x - 1, y - 1);
            int parts = One(!n && (ne || e)) + One(!e && (se || s)) + One(!s && (sw || w)) + One(!w && (nw || n));
            if (parts != 1)
                return false;
            int pairs = One(nw || n) + One(ne || e) + One(se || s) + One(sw || w);
            int others = One(n || ne) + One(e || se) + One(s || sw) + One(w || nw);
            int neighbours = pairs < others ? pairs : others;
            bool blocked = first ? (n || ne || !se) && e : (s || sw || !nw) && w;
            return neighbours >= 2 && neighbours <= 3 && !blocked;
        }

        private static int One(bool state) => state ? 1 : 0;
    }
}
