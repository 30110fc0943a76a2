namespace Alate.Catalogue
{
    /// <summary>Render pipeline that draws the scene, as far as materials differ.</summary>
    internal enum RenderPipelineKind
    {
        /// <summary>Built-in pipeline: no pipeline asset is set.</summary>
        BuiltIn,

        /// <summary>Universal Render Pipeline.</summary>
        Universal,

        /// <summary>High Definition Render Pipeline.</summary>
        HighDefinition,

        /// <summary>Custom pipeline.</summary>
        Other,
    }
}
