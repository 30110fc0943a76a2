namespace Alate.Catalogue
{
    /// <summary>Which render pipeline draws the scene, as far as materials differ.</summary>
    internal enum RenderPipelineKind
    {
        /// <summary>No pipeline asset is set.</summary>
        BuiltIn,

        /// <summary>URP.</summary>
        Universal,

        /// <summary>HDRP.</summary>
        HighDefinition,

        /// <summary>A pipeline of somebody's own.</summary>
        Other,
    }
}
