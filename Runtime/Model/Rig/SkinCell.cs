namespace Alate
{
    /// <summary>Vertices that one cell's four joints move: a run of <see cref="SkinQuad"/>.</summary>
    internal struct SkinCell
    {
        public int firstQuad;
        public int quadCount;
    }
}
