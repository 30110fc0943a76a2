using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class WingListTests : InsectFixture
    {
        [Test]
        public void Entries_AreTheSamePart_WhereTheFieldThatCountsIsTheSame()
        {
            MeshRenderer renderer = Insect().Wings[0].Renderer;
            var first = new Wing { Renderer = renderer, Part = WingPart.Submesh, Submesh = 1, Point = Vector3.one };

            Assert.That(WingList.SamePart(first, new Wing { Renderer = renderer, Part = WingPart.Submesh, Submesh = 1 }), Is.True);
            Assert.That(
                WingList.SamePart(first, new Wing { Renderer = renderer, Part = WingPart.Submesh, Submesh = 2, Point = Vector3.one }),
                Is.False);
            Assert.That(WingList.SamePart(first, new Wing { Renderer = renderer, Submesh = 1 }), Is.False);
            Assert.That(WingList.SamePart(first, null), Is.False);
        }

        [Test]
        public void Merge_KeepsWhatTheUserAddedFromOtherRenderers()
        {
            List<Wing> found = Insect().Wings, added = Insect().Wings;

            List<Wing> merged = WingList.Merge(added, found);

            Assert.That(merged, Is.EqualTo(new[] { found[0], found[1], added[0], added[1] }));
        }

        [Test]
        public void Merge_TakesTheOldEntryOfAWingThatWasFoundAgain()
        {
            List<Wing> old = Insect().Wings;
            var again = new Wing { Renderer = old[0].Renderer };

            Assert.That(WingList.Merge(old, new[] { again })[0], Is.SameAs(old[0]));
        }

        [Test]
        public void Names_TellForeFromHind_OnlyWhereThereAreHindWings()
        {
            List<Wing> wings = Insect().Wings;
            Assert.That(WingNames.Of(wings, 1), Is.EqualTo("Left"));

            wings[1].Pair = WingPair.Hind;

            Assert.That(WingNames.Of(wings, 0), Is.EqualTo("Fore Right"));
            Assert.That(WingNames.Of(wings, 1), Is.EqualTo("Hind Left"));
        }
    }
}
