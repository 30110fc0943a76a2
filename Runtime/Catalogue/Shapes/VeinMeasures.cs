namespace Alate.Catalogue
{
    /// <summary>Measured stiffness and vein widths of one chain; null lists leave those of the skeleton.</summary>
    internal struct VeinMeasures
    {
        /// <inheritdoc cref="JointChain.flexuralStiffness"/>
        public float[] flexuralStiffness;

        /// <inheritdoc cref="JointChain.torsionalStiffness"/>
        public float[] torsionalStiffness;

        /// <inheritdoc cref="JointChain.veinWidths"/>
        public float[] veinWidths;

        /// <summary>Gives a chain what was measured.</summary>
        public readonly void WriteTo(ref JointChain chain)
        {
            chain.flexuralStiffness = flexuralStiffness ?? chain.flexuralStiffness;
            chain.torsionalStiffness = torsionalStiffness ?? chain.torsionalStiffness;
            chain.veinWidths = veinWidths ?? chain.veinWidths;
        }
    }
}
