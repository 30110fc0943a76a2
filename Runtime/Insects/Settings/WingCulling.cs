namespace Alate
{
    /// <summary>What is computed while no camera sees an insect's wings.</summary>
    public enum WingCulling
    {
        /// <summary>Nothing: the beat stands still and is made up for when the wings come into view. Forces read as they last were.</summary>
        CullCompletely,

        /// <summary>Forces and joints; the mesh is not deformed.</summary>
        CullSkinning,

        /// <summary>Everything.</summary>
        AlwaysSimulate,
    }
}
