using System;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingMaterialTests
    {
        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        [TestCase(null, RenderPipelineKind.BuiltIn)]
        [TestCase("UniversalRenderPipelineAsset", RenderPipelineKind.Universal)]
        [TestCase("HDRenderPipelineAsset", RenderPipelineKind.HighDefinition)]
        [TestCase("MyPipelineAsset", RenderPipelineKind.Other)]
        public void APipeline_IsKnownByItsAsset(string assetType, object kind)
        {
            Assert.That(WingShaders.KindOf(assetType), Is.EqualTo((RenderPipelineKind)kind));
        }

        [TestCase(RenderPipelineKind.BuiltIn, "Alate/Wing, Standard")]
        [TestCase(RenderPipelineKind.Universal, "Alate/Wing, Universal Render Pipeline/Lit")]
        [TestCase(RenderPipelineKind.HighDefinition, "HDRP/Lit")]
        [TestCase(RenderPipelineKind.Other, "")]
        public void ForEachPipeline_ShadersAreTriedInOrder_AndOnlyThoseItDraws(object kind, string order)
        {
            var asked = new List<string>();
            Shader found = WingShaders.Choose((RenderPipelineKind)kind, name =>
            {
                asked.Add(name);
                return null;
            });

            Assert.That(found == null, Is.True);
            Assert.That(string.Join(", ", asked), Is.EqualTo(order));
        }

        [Test]
        public void TheFirstShaderThatIsThere_IsTaken()
        {
            Shader lit = WingMaterial.FindShader();
            Assert.That(lit != null, Is.True, "there is one in every project");
            Shader found = WingShaders.Choose(RenderPipelineKind.Universal, name => name == WingShaders.UniversalLit ? lit : null);

            Assert.That(found, Is.SameAs(lit));
        }

        [Test]
        public void APicture_IsKept_UntilAnotherDrawingOrSizeIsAskedFor()
        {
            var picture = new KeptPicture();
            object drawing = new object(), other = new object();
            int painted = 0;
            Color32[] Get(object of, int width, int height) => picture.Get(of, width, height, () =>
            {
                painted++;
                return new Color32[width * height];
            });
            Color32[] first = Get(drawing, 4, 2);

            Assert.That(Get(drawing, 4, 2), Is.SameAs(first));
            Assert.That(painted, Is.EqualTo(1));
            Assert.That(Get(drawing, 3, 2), Has.Length.EqualTo(6));
            Assert.That(Get(drawing, 3, 5), Has.Length.EqualTo(15));
            Get(other, 3, 5);
            Assert.That(painted, Is.EqualTo(4));
            GC.KeepAlive(first);
        }

        [TestCaseSource(nameof(All))]
        public void EachWingAndBody_GetsAMaterial_OfTheShaderForThisPipeline(InsectDefinition species)
        {
            Shader shader = WingMaterial.FindShader();
            foreach (WingDefinition wing in species.Wings)
            {
                Material material = WingMaterial.ForWing(wing, 32);

                Assert.That(material.shader, Is.SameAs(shader));
                Assert.That(material.mainTexture != null, Is.EqualTo(wing.Pattern != null));
                WingMaterial.Destroy(material);
            }

            Material skin = WingMaterial.ForBody(species, 32);
            Assert.That(skin.shader, Is.SameAs(shader));
            Assert.That(skin.mainTexture != null, Is.Not.EqualTo(WingMaterial.ShowsVertexColours(shader)));
            WingMaterial.Destroy(skin);
        }

        [Test]
        public void TheTextureOfAWing_HasTheWingsProportions_AndTheSizeAskedFor()
        {
            WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
            Material material = WingMaterial.ForWing(wing, 64);
            Texture texture = material.mainTexture;

            Assert.That(texture.width, Is.EqualTo(64));
            Assert.That(texture.height, Is.EqualTo(64 * (wing.Contour.Front - wing.Contour.Rear)).Within(0.51));
            Assert.That(texture.wrapMode, Is.EqualTo(TextureWrapMode.Clamp));
            WingMaterial.Destroy(material);
            Assert.That(texture == null, Is.True, "the texture goes with the material");
        }

        [Test]
        public void DestroyingNothing_IsNoError()
        {
            Assert.That(() => WingMaterial.Destroy(null), Throws.Nothing);
        }

        [TestCase(15)]
        [TestCase(8193)]
        [TestCase(-1)]
        public void ATexturesSize_OutOfRange_IsRefused_WithTheRange(int size)
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            Assert.That(
                () => WingMaterial.ForWing(monarch.Wings[0], size),
                Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("16 to 8192"));
            Assert.That(
                () => WingMaterial.ForBody(monarch, size),
                Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("16 to 8192"));
        }

        [Test]
        public void NoWingAndNoSpecies_AreRefused()
        {
            Assert.That(() => WingMaterial.ForWing(null), Throws.ArgumentNullException);
            Assert.That(() => WingMaterial.ForBody(null), Throws.ArgumentNullException);
        }
    }
}
