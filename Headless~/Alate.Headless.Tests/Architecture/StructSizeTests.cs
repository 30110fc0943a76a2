using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;

namespace Alate.Tests.Architecture
{
    /// <summary>Sizes of the structs that a step runs over, as their comments say them.</summary>
    public sealed unsafe class StructSizeTests
    {
        private const string k_Model = "Runtime/Model/";

        private static IEnumerable<TestCaseData> Structs()
        {
            yield return Said("State/WingPack.cs", "WingPack", "a pack", UnsafeUtility.SizeOf<WingPack>());
            yield return Said("State/WingPack.cs", "JointPose", "a wing", ALane(UnsafeUtility.SizeOf<JointPose>()));
            yield return Said("State/WingPack.cs", "PackReadings", "a wing", ALane(UnsafeUtility.SizeOf<PackReadings>()));
            yield return Said("State/BeatState.cs", "BeatState", "a wing", ALane(UnsafeUtility.SizeOf<BeatState>()));
            yield return Said("State/LaneParameters.cs", "LaneParameters", "a wing", ALane(UnsafeUtility.SizeOf<LaneParameters>()));
            yield return Said("State/NumberLanes.cs", "NumberLanes", "a wing", ALane(UnsafeUtility.SizeOf<NumberLanes>()));
            yield return Said("State/LaneSurroundings.cs", "LaneSurroundings", "a wing", ALane(UnsafeUtility.SizeOf<LaneSurroundings>()));
            yield return Said("State/PatchStream.cs", "PatchStream", "a wing", ALane(UnsafeUtility.SizeOf<PatchStream>()));
            yield return Said("Rig/RigView.cs", "RigView", "a rig", UnsafeUtility.SizeOf<RigView>());
            yield return Said("Skinning/SkinTarget.cs", "SkinTarget", "a wing", UnsafeUtility.SizeOf<SkinTarget>());
            yield return Said("Body/FlyingBody.cs", "FlyingBody", "a body", UnsafeUtility.SizeOf<FlyingBody>());
        }

        [TestCaseSource(nameof(Structs))]
        public void Bytes_AreThoseOfTheComment(string file, string name, string unit, long bytes) => Check(file, name, unit, bytes);

        [Test]
        public void BytesOfAMonarch_AreThoseOfTheComments()
        {
            WingRig rig = Monarch.Rig();
            try
            {
                using var pack = new PackMemory(rig.View, ModelOptions.Physical);

                Check("State/WingPack.cs", "WingPack", "a wing of a monarch", ALane(pack.Bytes));
                Check(
                    "State/StepScratch.cs", "StepScratch", "a worker for a monarch", StepScratch.Layout(RigSize.Of(rig.View), null, out _));
            }
            finally
            {
                rig.Release();
            }
        }

        private static long ALane(long bytes)
        {
            Assert.That(bytes % WingPack.Lanes, Is.Zero);
            return bytes / WingPack.Lanes;
        }

        private static TestCaseData Said(string file, string name, string unit, long bytes) =>
            new TestCaseData(file, name, unit, bytes).SetArgDisplayNames(name);

        private static void Check(string file, string name, string unit, long bytes)
        {
            string text = File.ReadAllText(Path.Combine(PackageRoot.Find(), k_Model + file));
            Match comment = Regex.Match(text, $@"((?: *///[^\n]*\n)+)(?: *\[[^\n]*\n)* *internal (?:unsafe )?struct {name}\b");

            Assert.That(Regex.Replace(comment.Groups[1].Value, @"\s*///\s*", " "),
                Does.Contain(FormattableString.Invariant($"{bytes:N0} bytes {unit}")), name);
        }
    }
}
