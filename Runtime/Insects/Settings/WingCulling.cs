namespace Alate
{
    /// <summary>Computation while no camera sees an insect's wings.</summary>
    public enum WingCulling
    {
        /// <summary>
        /// No computation: the beat stands still and is made up for when the wings come into view. Forces keep their last values.
        /// </summary>
        CullCompletely,

        /// <summary>Forces and joints are computed; the mesh is not deformed.</summary>
        CullSkinning,

        /// <summary>Full computation out of sight too.</summary>
        AlwaysSimulate,
    }
}
