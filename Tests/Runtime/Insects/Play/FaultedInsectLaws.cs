using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects that cannot live wait until something that they are made of has changed.</summary>
    public sealed class FaultedInsectLaws : FlockFixture
    {
        [UnityTest]
        public IEnumerator AnyChangeOfWhatItIsMadeOf_IsAnotherTry()
        {
            var watch = new AssetWatch<WingSkeleton, SkeletonValue>(asset => new SkeletonValue(asset));
            InsectWings insect = Hatch(made => made.enabled = false), other = Hatch(made => made.enabled = false);
            WingSkeleton own = Keep(TestWings.Fan(4, 4));
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            Wing first = insect.Wings[0];
            Wing spare = MakeWing(insect.transform, WingSide.Right);
            var faulted = new FaultedInsects(watch);
            faulted.Add(other);
            var mended = new List<InsectWings>();
            foreach ((string what, Action edit) in new (string, Action)[]
            {
                ("patches", () => insect.Quality.patches++),
                ("part", () => first.Part = WingPart.Submesh),
                ("submesh", () => first.Submesh = 3),
                ("point", () => first.Point = Vector3.up),
                ("side", () => first.Side = WingSide.Left),
                ("skeleton", () => first.Skeleton = own),
                ("skeleton's content", () => own.Hinge += Vector3.up),
                ("mesh", () => Filter(insect, 0).sharedMesh = mesh),
                ("mesh that is locked", () => mesh.UploadMeshData(true)),
                ("renderer", () => first.Renderer = spare.Renderer),
                ("order", () => insect.Wings.Reverse()),
                ("wing less", () => insect.Wings.RemoveAt(0)),
                ("wing more", () => insect.Wings.Add(spare)),
                ("no wing", () => insect.Wings[1] = null),
                ("no renderer", () => insect.Wings[0].Renderer = null),
            })
            {
                mended.Clear();
                faulted.Add(insect);
                faulted.TakeMended(mended);
                Assert.That(mended, Is.Empty, what);
                edit();
                watch.Refresh();
                faulted.TakeMended(mended);
                Assert.That(mended, Is.EqualTo(new[] { insect }), what);
                Assert.That(faulted.Count, Is.EqualTo(1), what);
            }

            faulted.Add(insect);
            faulted.Remove(other);
            Assert.That(faulted.Count, Is.EqualTo(1));
            faulted.Add(other);
            mended.Clear();
            faulted.TakeAll(mended);
            Assert.That(mended, Is.EqualTo(new[] { insect, other }));
            Assert.That(faulted.Count, Is.Zero);
            yield return null;
        }
    }
}
