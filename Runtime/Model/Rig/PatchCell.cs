namespace Alate
{
    /// <summary>Which patches lie in a cell.</summary>
    internal struct PatchCell
    {
        public int firstPatch;
        public int patchCount;
    }
}
