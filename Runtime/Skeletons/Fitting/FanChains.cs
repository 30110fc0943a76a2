using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// Lays the chains of a wing: the first along its leading edge, the last straight to the trailing edge, those between along level
    /// lines of a <see cref="FanField"/>.
    /// </summary>
    internal static class FanChains
    {
        /// <summary>[chain][joint] in the wing's view.</summary>
        public static PlanPoint[][] Lay(ClosedCurve outline, WingLandmarks marks, int chains, int joints)
        {
            var margin = new WingMargin(outline, marks);
            var made = new PlanPoint[chains][];
            made[0] = Jointed(OpenPath.Along(outline, marks.LeadingRoot, marks.Tip), joints, outline);
            made[chains - 1] = Jointed(new InnerPath(outline).Find(marks.TrailingRoot, marks.Last), joints, outline);

            PlanPoint firstRoot = made[0][0], lastRoot = made[chains - 1][0];
            FanField field = Field(made[0], margin, made[chains - 1], margin.Points[0] - marks.Base);
            for (int i = 1; i + 1 < chains; i++)
            {
                double share = (double)i / (chains - 1);
                PlanPoint root = firstRoot + (lastRoot - firstRoot) * share;
                made[i] = Jointed(LevelLine.Trace(field, share, root, margin.At(share)), joints, outline);
            }

            return made;
        }

        private static PlanPoint[] Jointed(IReadOnlyList<PlanPoint> path, int joints, ClosedCurve outline)
        {
            PlanPoint[] chain = OpenPath.Even(path, joints);
            ChainInset.Apply(chain, outline);
            return chain;
        }

        // Out along the first chain, along the margin and back along the last; the base closes the rim.
        private static FanField Field(PlanPoint[] first, WingMargin margin, PlanPoint[] last, PlanPoint axis)
        {
            var rim = new List<PlanPoint>(first);
            var values = new List<double>();
            while (values.Count < rim.Count)
                values.Add(0.0);
            for (int k = 1; k < margin.Points.Count; k++)
            {
                rim.Add(margin.Points[k]);
                values.Add(margin.Shares[k]);
            }

            for (int j = last.Length - 1; j >= 0; j--)
            {
                rim.Add(last[j]);
                values.Add(1.0);
            }

            return new FanField(rim, values, axis);
        }
    }
}
