using System;
using System.Globalization;
using System.Threading;
using Alate.Authoring;
using Alate.Tests;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonJsonTests
    {
        private const string k_Small =
            "{\"version\":1,\"hinge\":[0,0,0],\"span\":[1,0,0],\"up\":[0,1,0],\"chains\":[[[0,0,0],[0.5,0,0],[1,0,0]],[]]}";

        [Test]
        public void WhatIsWritten_ComesBackToTheLastBit()
        {
            var random = new Random(7);
            for (int round = 0; round < 50; round++)
            {
                WingSkeleton written = TestWings.Fan(random.Next(1, 6), random.Next(1, 6));
                foreach (JointChain chain in written.Chains)
                {
                    for (int j = 0; j < chain.Length; j++)
                        chain.joints[j] = AnyVector(random);
                }

                written.Hinge = AnyVector(random);
                written.SpanAxis = AnyVector(random);
                written.UpAxis = AnyVector(random);

                AssertEqual(SkeletonJson.Read(SkeletonJson.Write(written)), written);
            }
        }

        [Test]
        public void Numbers_AreAsShortAsTheyCanBe()
        {
            WingSkeleton written = TestWings.Fan();
            written.Hinge = new Vector3(0.1f, 1e-5f, 3.3f);

            Assert.That(SkeletonJson.Write(written), Does.Contain("[0.1,1E-05,3.3]").Or.Contain("[0.1, 1E-05, 3.3]"));
        }

        [Test]
        public void MeasuredStiffness_ComesBackToTheLastBit_AndOnlyWhereItWas()
        {
            WingSkeleton written = TestWings.Fan(4);
            written.Chains[0].flexuralStiffness = new[] { 1.3e-5f, 2.7e-7f };
            written.Chains[2].flexuralStiffness = new[] { 1e-6f };
            written.Chains[1].veinWidths = new[] { 0.1f, 0f };
            written.Chains[2].torsionalStiffness = new[] { 3.1e-7f, 1e-8f, 1e-9f };

            WingSkeleton read = SkeletonJson.Read(SkeletonJson.Write(written));

            AssertEqual(read, written);
            for (int i = 0; i < 4; i++)
            {
                Assert.That(read.Chains[i].flexuralStiffness ?? Array.Empty<float>(),
                    Is.EqualTo(written.Chains[i].flexuralStiffness ?? Array.Empty<float>()));
                Assert.That(
                    read.Chains[i].veinWidths ?? Array.Empty<float>(), Is.EqualTo(written.Chains[i].veinWidths ?? Array.Empty<float>()));
                Assert.That(read.Chains[i].torsionalStiffness ?? Array.Empty<float>(),
                    Is.EqualTo(written.Chains[i].torsionalStiffness ?? Array.Empty<float>()));
            }

            Assert.That(SkeletonJson.Write(TestWings.Fan()), Does.Not.Contain("Stiffness").And.Not.Contain("vein"));
        }

        [TestCase("\"flexuralStiffness\":[[1e-6]]", "\"flexuralStiffness\" has 1 lists for 2 chains.")]
        [TestCase("\"flexuralStiffness\":[1e-6]", "expected a list, found '1e-6'.")]
        [TestCase("\"torsionalStiffness\":[[NaN],[]]", "expected a number, found 'NaN'.")]
        [TestCase("\"flexuralStiffness\":[[1e-6],[]],\"flexuralStiffness\":[[1e-6],[]]", "\"flexuralStiffness\" appears twice.")]
        [TestCase("\"stiffness\":[]", "found '\"stiffness\"'.")]
        public void AFaultOfStiffness_IsNamed(string member, string reason)
        {
            Assert.That(Refusal(k_Small.Insert(k_Small.Length - 1, "," + member)), Does.Contain(reason));
        }

        [Test]
        public void TheSpellingOfNumbers_DoesNotDependOnTheCountry()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            var comma = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            comma.NumberFormat.NumberDecimalSeparator = ",";
            try
            {
                Thread.CurrentThread.CurrentCulture = comma;
                string written = SkeletonJson.Write(TestWings.Fan());

                Assert.That(written, Does.Contain("[0.25, 0, 0]"));
                AssertEqual(SkeletonJson.Read(written), TestWings.Fan());
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [Test]
        public void SpacesAndTheOrderOfKeys_AreFree()
        {
            WingSkeleton read = SkeletonJson.Read(
                "\uFEFF \r\n{ \"chains\" : [ [ [ 1e-1 , -0.5 , 2E+1 ] ] ] ,\t\"up\":[0,1,0],\"span\":[1,0,0],"
                + "\"hinge\":[1,2,3],\"version\":1 } \n");

            Assert.That(read.GetJoint(0, 0), Is.EqualTo(new Vector3(0.1f, -0.5f, 20f)));
            Assert.That(read.Hinge, Is.EqualTo(new Vector3(1f, 2f, 3f)));
        }

        [Test]
        public void ChainsWithoutJoints_AreReadAndLeftToValidation()
        {
            WingSkeleton read = SkeletonJson.Read(k_Small);

            Assert.That(read.ChainCount, Is.EqualTo(2));
            Assert.That(read.IsValid, Is.False);
        }

        [TestCase("", "line 1, column 1: expected '{', found the end of the text.")]
        [TestCase("  ", "line 1, column 3: expected '{', found the end of the text.")]
        [TestCase("# version 1", "line 1, column 1: expected '{', found '#'.")]
        [TestCase("[]", "expected '{'")]
        [TestCase("{}", "expected a key in double quotes, found '}'.")]
        [TestCase("{\"versions\":1}", "expected one of the keys version, hinge, span, up, chains, flexuralStiffness, torsionalStiffness, "
            + "veinWidths, found '\"versions\"'.")]
        [TestCase("{\"version\":1}", "\"hinge\" is missing.")]
        [TestCase("{\"version\":1,\"version\":1}", "\"version\" appears twice.")]
        [TestCase("{\"version\":1,}", "expected a key in double quotes")]
        public void ATextThatIsNoSkeleton_IsRefusedWithItsPlace(string text, string reason)
        {
            Assert.That(Refusal(text), Does.Contain(reason));
        }

        [TestCase("\"version\":1", "\"version\":2", "version 2 is not supported, only version 1.")]
        [TestCase("\"version\":1", "\"version\":\"1\"", "expected a number")]
        [TestCase("0.5", "NaN", "expected a number, found 'NaN'.")]
        [TestCase("0.5", "Infinity", "expected a number, found 'Infinity'.")]
        [TestCase("0.5", "-Infinity", "expected a number")]
        [TestCase("0.5", "null", "expected a number, found 'null'.")]
        [TestCase("0.5", "1e39", "the number is too large.")]
        [TestCase("0.5", "1e9999", "the number is too large.")]
        [TestCase("0.5", "+1", "expected a number")]
        [TestCase("0.5", ".5", "expected a number")]
        [TestCase("0.5", "5.", "expected a number")]
        [TestCase("0.5", "1e", "expected a number")]
        [TestCase("0.5", "05", "expected a number")]
        [TestCase("0.5", "0x5", "expected ','")]
        [TestCase("0.5", "0,5", "expected ']'")]
        [TestCase("[1,0,0],\"up\"", "[1,0],\"up\"", "expected ','")]
        [TestCase("[0.5,0,0]", "0.5", "expected a list of three numbers, found '0.5'.")]
        [TestCase("\"chains\":[", "\"chains\":{", "expected a list")]
        [TestCase("[]]}", "[]]}}", "expected the end of the text")]
        [TestCase("[]]}", "[]],//\n}", "expected a key")]
        public void AFaultInOnePlace_IsNamed(string right, string wrong, string reason)
        {
            Assert.That(Refusal(k_Small.Replace(right, wrong)), Does.Contain(reason));
        }

        [Test]
        public void AControlCharacter_IsNamedByItsNumber()
        {
            foreach (string wrong in new[] { "\a", "ab\a" })
                Assert.That(Refusal(k_Small.Replace("0.5", wrong)), Does.Contain("found a control character (U+0007)."));
        }

        [Test]
        public void LinesAreCounted()
        {
            string text = SkeletonJson.Write(TestWings.Fan()).Replace("[0.25, 0, 0]", "[0.25, 0]");

            Assert.That(Refusal(text), Does.StartWith("Skeleton JSON, line 7, column 25:"));
        }

        [Test]
        public void EveryTruncatedText_IsRefusedInOneLine()
        {
            string text = SkeletonJson.Write(TestWings.Fan(3, 3)).TrimEnd();
            for (int length = 0; length < text.Length; length++)
                Assert.That(Refusal(text.Substring(0, length)), Does.StartWith("Skeleton JSON, line").And.Not.Contain("\n"));
        }

        [Test]
        public void RandomDamage_NeverThrowsAnythingElse()
        {
            string text = SkeletonJson.Write(TestWings.Fan(3, 3));
            var random = new Random(11);
            for (int round = 0; round < 3000; round++)
            {
                char[] damaged = text.ToCharArray();
                for (int hit = random.Next(1, 4); hit > 0; hit--)
                    damaged[random.Next(damaged.Length)] = (char)random.Next(random.Next(2) == 0 ? 128 : 0xFFFF);
                try
                {
                    SkeletonJson.Read(new string(damaged));
                }
                catch (FormatException refusal)
                {
                    Assert.That(refusal.Message, Does.Not.Contain("\n").And.Not.Contain("\r"));
                }
            }
        }

        [Test]
        public void ANumberThatIsNotFinite_IsNotWritten()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[1].joints[1].z = float.NaN;

            Assert.Throws<ArgumentException>(() => SkeletonJson.Write(skeleton));
        }

        [Test]
        public void Nothing_IsRefused()
        {
            Assert.Throws<ArgumentNullException>(() => SkeletonJson.Read(null));
            Assert.Throws<ArgumentNullException>(() => SkeletonJson.Write(null));
        }

        private static string Refusal(string text) => Assert.Throws<FormatException>(() => SkeletonJson.Read(text)).Message;

        // Any finite float: random bits.
        private static Vector3 AnyVector(Random random) => new Vector3(AnyFloat(random), AnyFloat(random), AnyFloat(random));

        private static float AnyFloat(Random random)
        {
            float value = BitConverter.ToSingle(BitConverter.GetBytes(random.Next(int.MinValue, int.MaxValue)), 0);
            return float.IsNaN(value) || float.IsInfinity(value) ? 0.1f : value;
        }

        private static void AssertEqual(WingSkeleton actual, WingSkeleton expected)
        {
            Assert.That(Exactly(actual.Hinge), Is.EqualTo(Exactly(expected.Hinge)));
            Assert.That(Exactly(actual.SpanAxis), Is.EqualTo(Exactly(expected.SpanAxis)));
            Assert.That(Exactly(actual.UpAxis), Is.EqualTo(Exactly(expected.UpAxis)));
            Assert.That(actual.ChainCount, Is.EqualTo(expected.ChainCount));
            for (int i = 0; i < expected.ChainCount; i++)
            {
                Assert.That(actual.Chains[i].Length, Is.EqualTo(expected.Chains[i].Length));
                for (int j = 0; j < expected.Chains[i].Length; j++)
                    Assert.That(Exactly(actual.GetJoint(i, j)), Is.EqualTo(Exactly(expected.GetJoint(i, j))));
            }
        }

        private static (float, float, float) Exactly(Vector3 v) => (v.x, v.y, v.z);
    }
}
