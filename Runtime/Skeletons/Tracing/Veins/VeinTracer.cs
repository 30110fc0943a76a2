using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>Finds the radial veins in a picture of a wing.</summary>
    internal static class VeinTracer
    {
        /// <summary>The veins in pixels of the whole picture, z up; none when the picture shows no lines within the wing.</summary>
        public static List<RadialVein> Find(WorkingPicture picture, PixelMask wing, PlanPoint[] outline, TracedSkeleton skeleton)
        {
            double factor = picture.Factor, length = skeleton.Length / factor;
            PixelPlane response = RidgeField.Of(picture, wing, length);
            PixelMask lines = VeinMask.Of(response, wing, length);
            if (lines.Count == 0)
                return new List<RadialVein>();
            var graph = new VeinGraph(Thinning.Run(lines), length);
            var rim = new RimLine(Array.ConvertAll(outline, point => point * (1.0 / factor)));
            List<RadialVein> veins = RadialVeins.Find(graph, rim, skeleton.Hinge * (1.0 / factor), length);
            return veins.ConvertAll(vein => vein.Scaled(factor));
        }
    }
}
