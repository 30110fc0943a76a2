using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Insects
{
    /// <summary>
    /// Properties written into materials of shaders that only a project with their pipeline has, and the text of the package's own shader.
    /// </summary>
    public sealed class WingShaderTests
    {
        [TearDown]
        public void ForgetShaders()
        {
            ProjectShaders.Clear();
            BuiltPlayer.IsRunning = false;
        }

        [Test]
        public void ThePackagesShader_IsFoundInItsResourcesFolder_BeforeAnyOther()
        {
            Shader own = Added(WingMaterial.ShaderName, "Alate/Wing");

            Assert.That(WingMaterial.FindShader(), Is.SameAs(own));
            Assert.That(WingMaterial.ShowsVertexColours(own), Is.True);
            Assert.That(WingMaterial.ShowsVertexColours(Shader.Find("Standard")), Is.False);
        }

        [Test]
        public void WithoutIt_StandardIsTaken_WithATexturePainted()
        {
            Material body = WingMaterial.ForBody(InsectCatalogue.Find("firefly"), 64);

            Assert.That(body.shader.name, Is.EqualTo("Standard"));
            Assert.That(body.mainTexture.width, Is.EqualTo(64));
            WingMaterial.Destroy(body);
        }

        [TestCase("Alate/Wing", "_MainTex", BlendMode.One)]
        [TestCase("Universal Render Pipeline/Lit", "_BaseMap", BlendMode.SrcAlpha)]
        [TestCase("HDRP/Lit", "_BaseColorMap", BlendMode.One)]
        [TestCase("Standard", "_MainTex", BlendMode.SrcAlpha)]
        public void TranslucentWings_AreBlended_AndHideNothing(string shader, string textureName, BlendMode source)
        {
            var texture = new Texture2D(4, 4);
            Material wing = WingMaterial.Create(Added(shader), "wing", new SurfaceLook(texture, true, PictureOpacity.Clear));

            Assert.That(wing.GetTexture(textureName), Is.SameAs(texture));
            Assert.That((BlendMode)wing.GetFloat("_SrcBlend"), Is.EqualTo(source));
            Assert.That((BlendMode)wing.GetFloat("_DstBlend"), Is.EqualTo(BlendMode.OneMinusSrcAlpha));
            Assert.That(wing.GetFloat("_ZWrite"), Is.Zero);
            Assert.That(wing.renderQueue, Is.EqualTo(3000));
            Assert.That(wing.GetTag("RenderType", false), Is.EqualTo("Transparent"));
            Object.DestroyImmediate(wing);
            Object.DestroyImmediate(texture);
        }

        [TestCase("Alate/Wing", "_Cut", 1f, "_CUT")]
        [TestCase("Universal Render Pipeline/Lit", "_AlphaClip", 1f, "_ALPHATEST_ON")]
        [TestCase("HDRP/Lit", "_AlphaCutoffEnable", 1f, "_ALPHATEST_ON")]
        [TestCase("Standard", "_Mode", 1f, "_ALPHATEST_ON")]
        public void WingsThatAreCut_AreSolid_AndEndWhereTheirPictureDoes(string shader, string switched, float value, string keyword)
        {
            Material wing = WingMaterial.Create(Added(shader), "wing", new SurfaceLook(null, true, PictureOpacity.Cut)),
                solid = WingMaterial.Create(Added(shader), "wing", new SurfaceLook(null, true, PictureOpacity.Solid));

            Assert.That((wing.GetFloat(switched), wing.IsKeywordEnabled(keyword)), Is.EqualTo((value, true)));
            Assert.That((solid.GetFloat(switched), solid.IsKeywordEnabled(keyword)), Is.EqualTo((0f, false)));
            Assert.That((BlendMode)wing.GetFloat("_DstBlend"), Is.EqualTo(BlendMode.Zero));
            Assert.That(wing.GetFloat("_ZWrite"), Is.EqualTo(1f));
            Assert.That((wing.renderQueue, wing.GetTag("RenderType", false)), Is.EqualTo((2450, "TransparentCutout")));
            Object.DestroyImmediate(wing);
            Object.DestroyImmediate(solid);
        }

        [TestCase("Alate/Wing")]
        [TestCase("Universal Render Pipeline/Lit")]
        [TestCase("HDRP/Lit")]
        [TestCase("Standard")]
        public void SolidBodies_AreDrawnAsSolid(string shader)
        {
            Material body = WingMaterial.Create(Added(shader), "body", new SurfaceLook(null, false, PictureOpacity.Solid));

            Assert.That((BlendMode)body.GetFloat("_SrcBlend"), Is.EqualTo(BlendMode.One));
            Assert.That((BlendMode)body.GetFloat("_DstBlend"), Is.EqualTo(BlendMode.Zero));
            Assert.That(body.GetFloat("_ZWrite"), Is.EqualTo(1f));
            Assert.That(body.renderQueue, Is.EqualTo(-1), "the shader's own");
            Assert.That(body.IsKeywordEnabled("_SURFACE_TYPE_TRANSPARENT"), Is.False);
            Object.DestroyImmediate(body);
        }

        [TestCase("Alate/Wing", "_Cull")]
        [TestCase("Universal Render Pipeline/Lit", "_Cull")]
        [TestCase("HDRP/Lit", "_CullMode")]
        public void Wings_AreSeenFromBothSides_BodiesFromOutside(string shader, string cull)
        {
            Material wing = WingMaterial.Create(Added(shader), "wing", new SurfaceLook(null, true, PictureOpacity.Solid));
            Material body = WingMaterial.Create(Added(shader), "body", new SurfaceLook(null, false, PictureOpacity.Solid));

            Assert.That((CullMode)wing.GetFloat(cull), Is.EqualTo(CullMode.Off));
            Assert.That((CullMode)body.GetFloat(cull), Is.EqualTo(CullMode.Back));
            Object.DestroyImmediate(wing);
            Object.DestroyImmediate(body);
        }

        [Test]
        public void AFishWithClearFins_IsDrawnBeforeItsPectoralFins_AndStillHidesItsFarSide()
        {
            Added(WingMaterial.ShaderName, "Alate/Wing");
            Material fish = WingMaterial.ForBody(InsectCatalogue.Find("snailfish"));
            Material monarch = WingMaterial.ForBody(InsectCatalogue.Find("monarch"));

            Assert.That(fish.renderQueue, Is.EqualTo(2999));
            Assert.That(fish.GetFloat("_ZWrite"), Is.EqualTo(1f));
            Assert.That(fish.GetFloat("_VertexColours"), Is.EqualTo(1f));
            Assert.That(monarch.renderQueue, Is.EqualTo(-1));
            WingMaterial.Destroy(fish);
            WingMaterial.Destroy(monarch);
        }

        [TestCase("HDRP/Lit", true, "_DOUBLESIDED_ON, _SURFACE_TYPE_TRANSPARENT")]
        [TestCase("Universal Render Pipeline/Lit", true, "_SURFACE_TYPE_TRANSPARENT")]
        [TestCase("Standard", true, "_ALPHABLEND_ON")]
        public void InAPlayer_AMaterialWhoseFeaturesMayBeMissing_SaysSoOnce(string shader, bool isThin, string features)
        {
            BuiltPlayer.IsRunning = true;
            Shader added = Added(shader);
            LogAssert.Expect(LogType.Warning, new Regex($"'fore wing'.*{features} of {shader}.*GameObject > Alate"));
            Material first = WingMaterial.Create(added, "fore wing", new SurfaceLook(null, isThin, PictureOpacity.Clear));
            Material second = WingMaterial.Create(added, "hind wing", new SurfaceLook(null, isThin, PictureOpacity.Clear));

            LogAssert.NoUnexpectedReceived();
            Object.DestroyImmediate(first);
            Object.DestroyImmediate(second);
        }

        [Test]
        public void ThePackagesShader_AndTheEditor_MissNoFeatures([Values(0, 1, 2)] int opacity)
        {
            var look = new SurfaceLook(null, true, (PictureOpacity)opacity);
            Material editor = WingMaterial.Create(ProjectShaders.Add("HDRP/Lit"), "wing", look);
            BuiltPlayer.IsRunning = true;
            Material own = WingMaterial.Create(Added(WingMaterial.ShaderName), "wing", look);

            LogAssert.NoUnexpectedReceived();
            Assert.That(own.shaderKeywords, Is.EqualTo(look.IsCut ? new[] { "_CUT" } : new string[0]));
            Object.DestroyImmediate(editor);
            Object.DestroyImmediate(own);
        }

        [TestCase]
        [TestCase("_MainTex")]
        [TestCase("_BaseColorMap", "_Color")]
        public void OfAnUnknownShader_OnlyWhatItHas_IsTouched(params string[] properties)
        {
            Shader foreign = ProjectShaders.Add("Foreign/Toon", properties: properties);
            var texture = new Texture2D(4, 4);
            Material wing = WingMaterial.Create(foreign, "wing", new SurfaceLook(texture, true, PictureOpacity.Clear));

            LogAssert.NoUnexpectedReceived();
            foreach (string name in properties.Where(name => name != "_Color"))
                Assert.That(wing.GetTexture(name), Is.SameAs(texture));
            WingMaterial.Destroy(wing);
            LogAssert.NoUnexpectedReceived();
            Assert.That(texture == null, Is.EqualTo(properties.Length > 0), "the texture goes with its material, where that has it");
            Object.DestroyImmediate(texture);
        }

        [Test]
        public void TheShadersText_HasTheNameAndEveryProperty_ThatTheCodeUses()
        {
            string materials = Path.Combine(PackageRoot(), "Runtime", "Catalogue", "Materials");
            string code = File.ReadAllText(Path.Combine(materials, "LookProperties.cs"));
            string own = "\"_MainTex\"" + Regex.Match(code, @"void WriteOwn\(.*?\n        }", RegexOptions.Singleline).Value
                + Regex.Match(code, @"void WriteBlend\(.*?\n        }", RegexOptions.Singleline).Value;
            string[] written = Regex.Matches(own, "\"(_\\w+)\"").Select(match => match.Groups[1].Value).ToArray();

            Assert.That(Text(), Does.Contain($"Shader \"{WingMaterial.ShaderName}\""));
            Assert.That(written, Has.Length.GreaterThan(8));
            foreach (string name in written)
                Assert.That(OwnProperties(), Does.Contain(name));
        }

        [Test]
        public void TheShader_TellsUrpAndTheBuiltInPipelineApart()
        {
            string[] subshaders = Regex.Split(Text(), @"\n    SubShader\b").Skip(1).ToArray();

            Assert.That(subshaders, Has.Length.EqualTo(3));
            foreach (string universal in subshaders.Take(2))
                Assert.That(universal, Does.Contain("\"RenderPipeline\" = \"UniversalPipeline\"").And.Contain("PackageRequirements"));
            Assert.That(subshaders[2], Does.Not.Contain("render-pipelines"), "compiles without any pipeline's package");
            foreach (string subshader in subshaders)
                Assert.That(subshader, Does.Contain("\"LightMode\" = \"ShadowCaster\"").And.Contain("Cull [_Cull]"));
        }

        // The package's own shader has the properties of its text.
        private static Shader Added(string name, string resource = null) =>
            ProjectShaders.Add(name, resource, name == WingMaterial.ShaderName ? OwnProperties() : null);

        private static string[] OwnProperties()
        {
            string block = Regex.Match(Text(), @"\n    Properties\b.*?\n    }", RegexOptions.Singleline).Value;
            return Regex.Matches(block, @"\b(_\w+) \(").Select(match => match.Groups[1].Value).ToArray();
        }

        private static string Text() =>
            File.ReadAllText(Path.Combine(PackageRoot(), "Runtime", "Catalogue", "Materials", "Resources", "Alate", "Wing.shader"));

        private static string PackageRoot([CallerFilePath] string here = null) =>
            Path.GetFullPath(Path.Combine(Path.GetDirectoryName(here), "..", "..", ".."));
    }
}
