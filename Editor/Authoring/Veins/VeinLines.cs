using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Lines within a wing in a picture, which are its veins; places in pixels of the whole picture, z up.</summary>
    internal sealed class VeinLines
    {
        private readonly VeinGraph m_Graph;
        private readonly Polyline m_Rim;
        private readonly double m_Factor;
        private readonly double m_Extent;

        /// <param name="picture">The picture.</param>
        /// <param name="wing">The pixels of the wing.</param>
        /// <param name="outline">Of the wing.</param>
        public VeinLines(WorkingPicture picture, PixelMask wing, PlanPoint[] outline)
        {
            m_Factor = picture.Factor;
            m_Rim = new Polyline(Array.ConvertAll(outline, point => point * (1.0 / m_Factor)), true);
            m_Extent = new PlanBounds(outline).Extent / m_Factor;
            PixelMask lines = VeinMask.Of(RidgeField.Of(picture, wing, m_Extent), wing, m_Extent);
            m_Graph = new VeinGraph(Thinning.Run(lines), m_Extent);
        }

        /// <summary>Place where the veins come together; null when they do not tell.</summary>
        public PlanPoint? Focus => VeinFocus.Find(m_Graph, m_Rim, m_Extent) is PlanPoint focus ? focus * m_Factor : (PlanPoint?)null;

        /// <summary>The veins from near the hinge to the margin, the best seen first.</summary>
        public List<RadialVein> Radial(PlanPoint hinge, double length) =>
            RadialVeins.Find(m_Graph, m_Rim, hinge * (1.0 / m_Factor), length / m_Factor).ConvertAll(vein => vein.Scaled(m_Factor));
    }
}
