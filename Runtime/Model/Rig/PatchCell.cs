namespace Alate
{
    /// <summary>Range of patches that lie in a cell.</summary>
    internal struct PatchCell
    {
        public int firstPatch;
        public int patchCount;
    }
}
