using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class InsectFactoryTests
    {
        [Test]
        public void OutsideOfPlay_WhatIsMade_BelongsToTheScene_AndIsSharedWithNobody()
        {
            InsectWings one = InsectFactory.Create("firefly"), two = InsectFactory.Create("firefly");
            Mesh mesh = MeshOf(one), other = MeshOf(two);

            Assert.That(GeneratedAssets.InUse, Is.Empty);
            Assert.That(mesh.hideFlags, Is.EqualTo(HideFlags.None), "the mesh would not be saved with the scene");
            Assert.That(one.Preset.hideFlags, Is.EqualTo(HideFlags.None));
            Assert.That(other, Is.Not.SameAs(mesh));
            Assert.That(InsectStatus.Of(one).Problem.IsProblem, Is.False);
            foreach (InsectWings insect in new[] { one, two })
                Destroy(insect);
        }

        private static Mesh MeshOf(InsectWings insect) => insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh;

        private static void Destroy(InsectWings insect)
        {
            foreach (MeshRenderer renderer in insect.GetComponentsInChildren<MeshRenderer>())
            {
                WingMaterial.Destroy(renderer.sharedMaterial);
                Object.DestroyImmediate(renderer.GetComponent<MeshFilter>().sharedMesh);
            }

            Object.DestroyImmediate(insect.Wings[0].Skeleton);
            Object.DestroyImmediate(insect.Preset);
            Object.DestroyImmediate(insect.gameObject);
        }
    }
}
