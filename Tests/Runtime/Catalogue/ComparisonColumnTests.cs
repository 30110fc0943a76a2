using System;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class ComparisonColumnTests
    {
        private WingPreset m_Full, m_Copy;

        [SetUp]
        public void CreatePreset()
        {
            m_Full = InsectCatalogue.Find("fishfly").Wings[0].CreatePreset();
            m_Full.name = "Fishfly";
        }

        [TearDown]
        public void DestroySpecies()
        {
            UnityEngine.Object.DestroyImmediate(m_Full);
            UnityEngine.Object.DestroyImmediate(m_Copy);
        }

        [Test]
        public void Columns_AreThePapersFour_InOrder()
        {
            Assert.That(
                ComparisonColumn.All.Select(column => column.Name), Is.EqualTo(new[] { "rigid", "no-wave", "full", "elasticity-0.25" }));
            Assert.That(ComparisonColumn.All.Select(column => column.Title), Is.Unique.And.All.Not.Empty);
        }

        [Test]
        public void TheFullModel_IsTheSpeciesItself()
        {
            m_Copy = ComparisonColumn.FullModel.CreatePreset(m_Full);

            Assert.That(m_Copy, Is.Not.SameAs(m_Full));
            Assert.That(m_Copy.ToParameters(), Is.EqualTo(m_Full.ToParameters()));
            Assert.That(m_Copy.name, Is.EqualTo("Fishfly (full)"));
        }

        [Test]
        public void WithoutTheWave_OnlyTheDelaysAreGone()
        {
            m_Copy = ComparisonColumn.NoWave.CreatePreset(m_Full);

            WingParameters expected = m_Full.ToParameters();
            expected.chordDelay = 0f;
            expected.spanDelay = 0f;
            Assert.That(m_Copy.ToParameters(), Is.EqualTo(expected));
        }

        [Test]
        public void ARigidWing_IsDrivenWholeAtItsRoot_AndBeatsAsBefore()
        {
            m_Copy = ComparisonColumn.RigidWing.CreatePreset(m_Full);

            Assert.That(m_Copy.Wave.rootShare, Is.EqualTo(1f));
            Assert.That(m_Copy.Stiffness.jointLimit, Is.Zero);
            Assert.That(m_Copy.Wave.chordDelay + m_Copy.Wave.spanDelay, Is.Zero);
            Assert.That(m_Copy.Beat, Is.EqualTo(m_Full.Beat));
            Assert.That(m_Copy.Size, Is.EqualTo(m_Full.Size));
        }

        [TestCase(0.25f)]
        [TestCase(4f)]
        public void AnotherElasticity_ScalesTheSpeciesOwn(float factor)
        {
            m_Copy = ComparisonColumn.Elasticity(factor).CreatePreset(m_Full);

            WingParameters expected = m_Full.ToParameters();
            expected.elasticity *= factor;
            Assert.That(m_Copy.ToParameters(), Is.EqualTo(expected));
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void AnImpossibleElasticity_IsRefused(float factor)
        {
            Assert.That(() => ComparisonColumn.Elasticity(factor),
                Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("elasticity"));
        }

        [Test]
        public void EveryColumn_FollowsTheSpecies_AsIfItWereMadeAnew()
        {
            foreach (ComparisonColumn column in ComparisonColumn.All)
            {
                WingPreset kept = column.CreatePreset(m_Full);
                m_Full.Wave.chordDelay += 0.1f;
                m_Full.Beat.flapRange -= 5f;
                m_Full.Stiffness.elasticity *= 1.5f;
                m_Full.Size.wingLength *= 1.2f;
                m_Full.Size.insectMass *= 1.1f;
                m_Full.SubstepsPerBeat += 4;
                m_Full.Kinematics.frequency += 1f;
                m_Full.Options.clampLift = !m_Full.Options.clampLift;

                column.Refresh(m_Full, kept);

                m_Copy = column.CreatePreset(m_Full);
                Assert.That(kept.ToParameters(), Is.EqualTo(m_Copy.ToParameters()), column.Name);
                Assert.That((kept.Size, kept.Kinematics.frequency), Is.EqualTo((m_Full.Size, m_Full.Kinematics.frequency)), column.Name);
                UnityEngine.Object.DestroyImmediate(kept);
                UnityEngine.Object.DestroyImmediate(m_Copy);
            }
        }

        [Test]
        public void TheSpecies_StaysAsItIs()
        {
            WingParameters before = m_Full.ToParameters();

            foreach (ComparisonColumn column in ComparisonColumn.All)
            {
                UnityEngine.Object.DestroyImmediate(column.CreatePreset(m_Full));
            }

            Assert.That(m_Full.ToParameters(), Is.EqualTo(before));
        }

        [Test]
        public void AMissingSpecies_IsRefused_AndOneThatIsItsOwnCopy()
        {
            Assert.That(() => ComparisonColumn.NoWave.CreatePreset(null), Throws.ArgumentNullException);
            Assert.That(() => ComparisonColumn.NoWave.Refresh(null, m_Full), Throws.ArgumentNullException);
            Assert.That(() => ComparisonColumn.NoWave.Refresh(m_Full, null), Throws.ArgumentNullException);
            Assert.That(() => ComparisonColumn.NoWave.Refresh(m_Full, m_Full), Throws.ArgumentException.With.Message.Contains("Fishfly"));
        }
    }
}
