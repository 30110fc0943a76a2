namespace Alate
{
    /// <summary>Results of a bake, in managed arrays.</summary>
    internal sealed class RigContent
    {
        public WingFrame frame;
        public RestSkeleton rest;
        public int triangleCount;
        public float area;
        public float[] jointMasses;
        public float[] jointInertias;
        public float[] addedMasses;
        public float[] addedInertias;
        public BeamHinges beams;
        public float[] veinFactors;
        public bool hasVeins;
        public float[] leverDamping;
        public Spring[] springs;
        public StripNetwork strips;
        public PatchLayout patches;
        public PatchLayout coarsePatches;
        public VertexInfluences influences;
        public SkinLayout skin;
    }
}
