namespace Alate
{
    /// <summary>Vertices that one cell's four joints move: a run of <see cref="SkinQuad"/>.</summary>
    internal struct SkinCell
    {
        public int firstQuad;
        public int quadCount;

        /// <summary>Number of the first of them that hold the vertices of a smaller mesh; all where there is none.</summary>
        public int smallerQuads;
    }
}
