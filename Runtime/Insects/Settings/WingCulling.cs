namespace Alate
{
    /// <summary>What is saved while no camera sees an insect's wings.</summary>
    public enum WingCulling
    {
        /// <summary>Everything: the beat stands still and is made up for when the wings come into view. Forces read as they last were.</summary>
        Everything,

        /// <summary>The mesh is not deformed; forces and joints are computed on.</summary>
        Skinning,

        /// <summary>Nothing.</summary>
        Nothing,
    }
}
