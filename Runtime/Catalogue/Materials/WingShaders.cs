using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Catalogue
{
    /// <summary>Finds a shader that the active render pipeline can draw wings with.</summary>
    internal static class WingShaders
    {
        /// <summary>Name of the package's own shader, which shows vertex colours.</summary>
        public const string Own = "Alate/Wing";

        /// <summary>Keyword of the package's shader for wings that end where their picture does.</summary>
        public const string Cut = "_CUT";

        public const string UniversalLit = "Universal Render Pipeline/Lit";
        public const string HighDefinitionLit = "HDRP/Lit";
        public const string Standard = "Standard";

        /// <summary>Path of the package's shader in a Resources folder, which every player build includes.</summary>
        private const string k_OwnResource = "Alate/Wing";

        /// <summary>Render pipeline that draws now.</summary>
        public static RenderPipelineKind ActivePipeline
        {
            get
            {
                RenderPipelineAsset asset = GraphicsSettings.currentRenderPipeline;
                return KindOf(asset == null ? null : asset.GetType().Name);
            }
        }

        /// <summary>The kind of a pipeline by the type name of its asset; null is the built-in pipeline, which has none.</summary>
        public static RenderPipelineKind KindOf(string assetType)
        {
            return assetType switch
            {
                null => RenderPipelineKind.BuiltIn,
                "UniversalRenderPipelineAsset" => RenderPipelineKind.Universal,
                "HDRenderPipelineAsset" => RenderPipelineKind.HighDefinition,
                _ => RenderPipelineKind.Other,
            };
        }

        /// <summary>
        /// Names of the shaders to try, the best one first. The package's shader has no pass that HDRP or an unknown pipeline would draw.
        /// </summary>
        public static string[] NamesFor(RenderPipelineKind pipeline)
        {
            return pipeline switch
            {
                RenderPipelineKind.BuiltIn => new[] { Own, Standard },
                RenderPipelineKind.Universal => new[] { Own, UniversalLit },
                RenderPipelineKind.HighDefinition => new[] { HighDefinitionLit },
                _ => Array.Empty<string>(),
            };
        }

        /// <summary>Finds the best shader in the build; null if there is none.</summary>
        /// <param name="pipeline">The pipeline that shall draw.</param>
        /// <param name="find">Finds a shader by its name, or gives null.</param>
        public static Shader Choose(RenderPipelineKind pipeline, Func<string, Shader> find)
        {
            foreach (string name in NamesFor(pipeline))
            {
                Shader shader = find(name);
                if (shader != null)
                    return shader;
            }

            return null;
        }

        /// <summary>Finds a shader by name; the package's own also where no material of the build refers to it.</summary>
        public static Shader Find(string name)
        {
            Shader shader = name == Own ? Resources.Load<Shader>(k_OwnResource) : null;
            return shader != null ? shader : Shader.Find(name);
        }

        /// <summary>Default shader of the pipeline; null without a pipeline asset, or in players of some pipelines.</summary>
        public static Shader PipelinesOwn()
        {
            RenderPipelineAsset asset = GraphicsSettings.currentRenderPipeline;
            return asset == null ? null : asset.defaultShader;
        }
    }
}
