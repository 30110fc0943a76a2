using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class AssetWatchTests
    {
        private const int k_Long = 1000;

        private WingPreset m_Preset;
        private AssetWatch<WingPreset, PresetValues> m_Watch;

        [SetUp]
        public void Begin()
        {
            m_Preset = InsectCatalogue.Monarch();
            m_Watch = new AssetWatch<WingPreset, PresetValues>(asset => new PresetValues(asset));
        }

        [TearDown]
        public void End() => Object.DestroyImmediate(m_Preset);

        [Test]
        public void Presets_AreReadOnceForAll_AndAgainWhenEdited()
        {
            PresetValues values = m_Watch.Of(m_Preset);
            int stamp = values.Stamp;
            Assert.That(m_Watch.Of(m_Preset), Is.SameAs(values));
            m_Watch.Refresh();
            Assert.That(values.Stamp, Is.EqualTo(stamp), "nothing was edited");

            m_Preset.Beat.flapRange *= 0.5f;
            m_Watch.Refresh();
            Assert.That(values.Stamp, Is.Not.EqualTo(stamp));
        }

        [Test]
        public void PresetsInUse_AreKept_HoweverLong()
        {
            PresetValues values = m_Watch.Of(m_Preset);
            for (int round = 0; round < k_Long; round++)
            {
                Round();
                Assert.That(values.Stamp, Is.GreaterThanOrEqualTo(0));
            }

            Assert.That(m_Watch.Of(m_Preset), Is.SameAs(values));
            Assert.That(m_Watch.Count, Is.EqualTo(1));
        }

        [Test]
        public void PresetsOutOfUse_AreLetGo_AndFoundAnew()
        {
            PresetValues values = m_Watch.Of(m_Preset);
            for (int round = 0; round < k_Long; round++)
                Round();

            Assert.That(m_Watch.Count, Is.Zero, "nobody looks, yet the preset is held");
            Assert.That(values.IsForgotten, Is.True);
            Assert.That(values.Stamp, Is.GreaterThanOrEqualTo(0));
            Assert.That(values.IsForgotten, Is.True, "a look at what is read no more does not bring it back");
            Assert.That(m_Watch.Of(m_Preset), Is.Not.SameAs(values));
        }

        [Test]
        public void WhatNobodyLookedAt_ForSixHundredRounds_IsLetGoInTheNext()
        {
            PresetValues values = m_Watch.Of(m_Preset);
            for (int round = 0; round < 600; round++)
                m_Watch.EndRound();
            Assert.That((m_Watch.Count, values.IsForgotten), Is.EqualTo((1, false)));
            m_Watch.EndRound();
            Assert.That((m_Watch.Count, values.IsForgotten), Is.EqualTo((0, true)));
        }

        [Test]
        public void NoPreset_AndADestroyedOne_AreAMonarch_AndNotWatched()
        {
            PresetValues none = m_Watch.Of(null);
            WingPreset gone = InsectCatalogue.Monarch();
            Object.DestroyImmediate(gone);

            Assert.That(m_Watch.Of(gone), Is.SameAs(none));
            Assert.That(none.size.wingLength, Is.EqualTo(PresetSize.Default.wingLength));
            Assert.That(m_Watch.Count, Is.Zero);
        }

        private void Round()
        {
            m_Watch.EndRound();
            m_Watch.Refresh();
        }
    }
}
