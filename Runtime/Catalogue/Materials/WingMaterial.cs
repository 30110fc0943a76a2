using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Plain materials for generated wings and bodies in every render pipeline: the package's own shader in the built-in pipeline and URP,
    /// HDRP/Lit with a painted texture in HDRP. Materials made here belong to the caller; <see cref="Destroy"/> frees one with its texture.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public static class WingMaterial
    {
        /// <summary>Name of the package's shader. It lies in a Resources folder, so that player builds have it.</summary>
        public const string ShaderName = WingShaders.Own;

        /// <summary>Pixels along the longer side of a texture, unless asked otherwise.</summary>
        public const int DefaultTextureSize = 512;

        private const int k_LeastSize = 16, k_MostSize = 8192;

        /// <summary>Colour of a wing without a pattern.</summary>
        private static readonly Color s_Membrane = new Color(0.84f, 0.79f, 0.66f);

        /// <summary>
        /// The shader for the pipeline that draws now: built-in: <see cref="ShaderName"/>, then Standard; URP: <see cref="ShaderName"/>,
        /// then Universal Render Pipeline/Lit; HDRP: HDRP/Lit; any other pipeline: its default shader. Null where none of them is in the
        /// build.
        /// </summary>
        public static Shader FindShader()
        {
            Shader found = WingShaders.Choose(WingShaders.ActivePipeline, WingShaders.Find);
            return found != null ? found : WingShaders.PipelinesOwn();
        }

        /// <summary>Returns true where a shader shows vertex colours; others need a texture.</summary>
        public static bool ShowsVertexColours(Shader shader) => shader != null && shader.name == ShaderName;

        /// <summary>
        /// A material for a kind of wing, the same for left and right: its picture in its own size, or its pattern as a texture, which is
        /// finer than vertex colours, or a pale membrane where it has neither. Translucent where the alpha is below 1.
        /// </summary>
        /// <param name="wing">The wing.</param>
        /// <param name="textureSize">Pixels along the longer side, 16 to 8192.</param>
        /// <exception cref="ArgumentOutOfRangeException">The size is out of range.</exception>
        /// <exception cref="InvalidOperationException">No shader was found; the message says how to put one into the build. Or the picture
        /// of the wing is damaged.</exception>
        public static Material ForWing(WingDefinition wing, int textureSize = DefaultTextureSize) => ForWing(wing, textureSize, false);

        /// <summary>Material of a wing whose texture can be read and saved.</summary>
        internal static Material ForWing(WingDefinition wing, int textureSize, bool keepPixels)
        {
            if (wing == null)
                throw new ArgumentNullException(nameof(wing));
            CheckSize(textureSize);
            Shader shader = RequireShader();
            if (wing.Picture != null)
            {
                Color32[] own = Decode(wing, out int columns, out int rows);
                Texture2D picture = ToTexture(wing.Name, own, columns, rows, keepPixels);
                return Create(shader, wing.Name, new SurfaceLook(picture, true, PictureOpacities.Of(own, columns)));
            }

            if (wing.Pattern == null)
            {
                Material plain = Create(shader, wing.Name, new SurfaceLook(null, true, PictureOpacity.Solid));
                plain.SetSurfaceColour(s_Membrane);
                return plain;
            }

            WingOutline outline = wing.Contour;
            double depth = outline.Front - outline.Rear;
            double longer = Math.Max(depth, 1);
            int width = Math.Max(1, (int)Math.Round(textureSize / longer));
            int height = Math.Max(1, (int)Math.Round(textureSize * depth / longer));
            Color32[] pixels = wing.Painted.Get(wing.Pattern, width, height, () => wing.Paint(width, height));
            Texture2D painted = ToTexture(wing.Name, pixels, width, height, keepPixels);
            return Create(
                shader, wing.Name, new SurfaceLook(painted, true, PictureOpacities.Of(pixels, width), wing.Pattern.Underside));
        }

        /// <summary>
        /// Makes a material for a species' body: vertex colours, or a texture painted with them where the shader shows none.
        /// </summary>
        /// <param name="species">The species.</param>
        /// <param name="textureSize">Pixels along each side, 16 to 8192, where a texture is needed.</param>
        /// <exception cref="ArgumentOutOfRangeException">The size is out of range.</exception>
        /// <exception cref="InvalidOperationException">No shader was found; the message says how to put one into the build.</exception>
        public static Material ForBody(InsectDefinition species, int textureSize = DefaultTextureSize) =>
            ForBody(species, textureSize, false);

        internal static Material ForBody(InsectDefinition species, int textureSize, bool keepPixels)
        {
            if (species == null)
                throw new ArgumentNullException(nameof(species));
            CheckSize(textureSize);
            Shader shader = RequireShader();
            SurfaceMesh body = species.Body.CreateSurface(InsectDefinition.UnitsPerMetre);
            string name = species.DisplayName + " body";
            Texture2D texture = null;
            if (!ShowsVertexColours(shader))
            {
                Color32[] pixels = species.Body.Picture.Get(
                    species.Body, textureSize, textureSize, () => ColourTexture.Paint(body, textureSize));
                texture = ToTexture(name, pixels, textureSize, textureSize, keepPixels);
            }

            return Create(shader, name, new SurfaceLook(texture, false, PictureOpacities.Of(HasClearPixels(body.colours))));
        }

        /// <summary>
        /// A material for a mesh of one's own with vertex colours. In HDRP, whose shader shows none, it is white: give
        /// <see cref="Material.mainTexture"/> a texture.
        /// </summary>
        /// <param name="isWing">Seen from both sides, with light shining through; else a closed body.</param>
        /// <param name="isTranslucent">Whether what lies behind is seen through where alpha is below 1.</param>
        /// <exception cref="InvalidOperationException">No shader was found; the message says how to put one into the build.</exception>
        public static Material ForVertexColours(bool isWing, bool isTranslucent) =>
            Create(RequireShader(), isWing ? "Wing" : "Body", new SurfaceLook(null, isWing, PictureOpacities.Of(isTranslucent)));

        /// <summary>Frees a material that was made here, and its texture. Null is no error.</summary>
        public static void Destroy(Material material)
        {
            if (material == null)
                return;
            Texture texture = material.SurfaceTexture();
            ObjectEnd.Destroy(material);
            ObjectEnd.Destroy(texture);
        }

        internal static Material Create(Shader shader, string name, in SurfaceLook look)
        {
            var material = new Material(shader) { name = name };
            LookProperties.Write(material, look);
            ShaderFeatures.Check(material);
            return material;
        }

        private static Shader RequireShader()
        {
            Shader shader = FindShader();
            return shader != null
                ? shader
                : throw new InvalidOperationException(
                    $"No shader for wings was found: neither '{ShaderName}' nor a lit one of the render pipeline is in this build. Use a "
                    + "material with one of them in a scene, or list it under "
                    + "Project Settings > Graphics > Always Included Shaders.");
        }

        private static Texture2D ToTexture(string name, Color32[] pixels, int width, int height, bool keepPixels)
        {
            var texture = new Texture2D(width, height, TextureFormat.RGBA32, true) { name = name, wrapMode = TextureWrapMode.Clamp };
            texture.SetPixels32(pixels);
            texture.Apply(true, !keepPixels);
            return texture;
        }

        private static Color32[] Decode(WingDefinition wing, out int width, out int height)
        {
            var read = new Texture2D(1, 1);
            bool isPicture = read.LoadImage(wing.Picture);
            Color32[] pixels = read.GetPixels32();
            (width, height) = (read.width, read.height);
            ObjectEnd.Destroy(read);
            return isPicture
                ? pixels
                : throw new InvalidOperationException($"The picture of the {wing.Name} is damaged, or neither a PNG nor a JPEG.");
        }

        private static bool HasClearPixels(Color32[] colours) => Array.Exists(colours, colour => colour.a < byte.MaxValue);

        private static void CheckSize(int size)
        {
            if (size < k_LeastSize || size > k_MostSize)
            {
                throw new ArgumentOutOfRangeException(
                    nameof(size), size, $"A texture has {k_LeastSize} to {k_MostSize} pixels along its longer side.");
            }
        }
    }
}
