#if ENABLE_UNITY_COLLECTIONS_CHECKS
using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// Fields of the two jobs of a frame, which are checked before they are scheduled where Unity's safety checks are on.
    /// </summary>
    public sealed unsafe class JobFieldTests
    {
        private NativeArray<WingPack> m_Packs;
        private NativeArray<PackGroup> m_Groups;
        private NativeArray<int> m_List;
        private NativeArray<SkinTarget> m_Targets;
        private NativeArray<SkinChunk> m_Chunks;
        private NativeArray<ChunkBounds> m_Bounds;
        private byte* m_Memory;

        [SetUp]
        public void SetUp()
        {
            m_Packs = new NativeArray<WingPack>(2, Allocator.Persistent);
            m_Groups = new NativeArray<PackGroup>(2, Allocator.Persistent);
            m_List = new NativeArray<int>(2, Allocator.Persistent);
            m_Targets = new NativeArray<SkinTarget>(1, Allocator.Persistent);
            m_Chunks = new NativeArray<SkinChunk>(2, Allocator.Persistent);
            m_Bounds = new NativeArray<ChunkBounds>(2, Allocator.Persistent);
            m_Memory = (byte*)UnsafeUtility.MallocTracked(64, 64, Allocator.Persistent, 0);
            m_List[1] = 1;
            m_Groups[0] = new PackGroup { packCount = 1 };
            m_Groups[1] = new PackGroup { firstPack = 1, packCount = 1 };
            m_Targets[0] = new SkinTarget
            {
                rig = new RigView { quadCount = 9, vertexCount = 33 },
                pack = 1,
                lane = 3,
                vertices = (SkinnedVertex*)m_Memory,
            };
            m_Chunks[0] = new SkinChunk { endQuad = 5 };
            m_Chunks[1] = new SkinChunk { firstQuad = 5, endQuad = 9 };
        }

        [TearDown]
        public void TearDown()
        {
            m_Packs.Dispose();
            m_Groups.Dispose();
            m_List.Dispose();
            m_Targets.Dispose();
            m_Chunks.Dispose();
            m_Bounds.Dispose();
            UnsafeUtility.FreeTracked(m_Memory, Allocator.Persistent);
        }

        [Test]
        public void AStep_WhoseFieldsAreInRange_IsTaken() => Assert.That(() => Step(Due(0.02f)).Validate(2), Throws.Nothing);

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(-0.001f)]
        public void AStepOfNoLength_IsRefused(float length)
        {
            Expect(() => Step(Due(length)).Validate(2), "The length of a step");
            Expect(() => Skin(Due(length)).Validate(2), "The length of a step");
        }

        [Test]
        public void StepsBackwards_AreRefused()
        {
            Expect(() => Step(ClockTimes.All(new ClockTime { length = 0.02f, count = -1 })).Validate(2), "The number of steps is -1");
            Expect(() => Step(ClockTimes.All(new ClockTime { length = 0.02f, substeps = -2 })).Validate(2), "The number of substeps is -2");
        }

        [TestCase(1.5f)]
        [TestCase(-0.1f)]
        [TestCase(float.NaN)]
        public void ATimeOutsideTheStep_IsNotDrawn(float alpha) =>
            Expect(() => Skin(ClockTimes.All(new ClockTime { alpha = alpha })).Validate(2), "The time within a step that is drawn");

        [Test]
        public void AStep_OfMoreGroupsThanThereAre_IsRefused() =>
            Expect(() => Step(Due(0.02f)).Validate(3), "StepWingsJob.groups has room for 2; the job needs 3.");

        [Test]
        public void AStep_OfPacksThatDoNotExist_IsRefused()
        {
            m_Groups[1] = new PackGroup { firstPack = 1, packCount = 2 };
            Expect(() => Step(Due(0.02f)).Validate(2), "StepWingsJob.groups.packCount is 2; it must be from 1 to 1.");
            m_Groups[1] = new PackGroup { firstPack = 2, packCount = 1 };
            Expect(() => Step(Due(0.02f)).Validate(2), "StepWingsJob.groups.firstPack is 2");
            m_Groups[1] = new PackGroup { firstPack = 1, packCount = 1 };
            m_List[1] = 2;
            Expect(() => Step(Due(0.02f)).Validate(2), "StepWingsJob.lists.packList is 2; it must be from 0 to 1.");
        }

        [Test]
        public void AStep_WithTooLittleScratch_IsRefused()
        {
            StepWingsJob job = Step(Due(0.02f));
            job.scratchSize = new RigSize { joints = 20, bones = 16, patches = 40 };
            Expect(() => job.Validate(2), "StepWingsJob.scratch has room for");
        }

        [Test]
        public void Skinning_WhoseFieldsAreInRange_IsTaken() => Assert.That(() => Skin(default).Validate(2), Throws.Nothing);

        [Test]
        public void Skinning_OutsideItsArrays_IsRefused()
        {
            Expect(() => Skin(default).Validate(3), "SkinWingsJob.chunks has room for 2; the job needs 3.");
            SkinWingsJob job = Skin(default);
            job.bounds = new NativeArray<ChunkBounds>(1, Allocator.Temp);
            Expect(() => job.Validate(2), "SkinWingsJob.bounds has room for 1; the job needs 2.");
            m_Chunks[1] = new SkinChunk { firstQuad = 5, endQuad = 10 };
            Expect(() => Skin(default).Validate(2), "SkinWingsJob.chunks.endQuad is 10; it must be from 0 to 9.");
            m_Chunks[1] = new SkinChunk { firstQuad = 6, endQuad = 5 };
            Expect(() => Skin(default).Validate(2), "SkinWingsJob.chunks.firstQuad is 6; it must be from 0 to 5.");
            m_Chunks[1] = new SkinChunk { target = 1 };
            Expect(() => Skin(default).Validate(2), "SkinWingsJob.chunks.target is 1; it must be from 0 to 0.");
        }

        [Test]
        public void Skinning_OfAWingWithoutPackOrVertices_IsRefused()
        {
            SkinTarget target = m_Targets[0];
            target.pack = 2;
            m_Targets[0] = target;
            Expect(() => Skin(default).Validate(2), "SkinWingsJob.targets.pack is 2; it must be from 0 to 1.");
            target.pack = 1;
            target.lane = 4;
            m_Targets[0] = target;
            Expect(() => Skin(default).Validate(2), "SkinWingsJob.targets.lane is 4; it must be from 0 to 3.");
            target.lane = 3;
            target.vertices = null;
            m_Targets[0] = target;
            Expect(() => Skin(default).Validate(2), "SkinWingsJob.targets.vertices has room for 0; the job needs 33.");
        }

        [Test]
        public void Skinning_WhoseJointsHaveNoRoom_IsRefused()
        {
            SkinTarget target = m_Targets[0];
            target.placed = 6;
            target.rig.jointCount = 25;
            target.vertices = null;
            m_Targets[0] = target;
            SkinWingsJob job = Skin(default);
            job.joints = new NativeArray<float4>(59, Allocator.Temp);
            Expect(() => job.Validate(2), "SkinWingsJob.joints has room for 59; the job needs 60.");
            job.joints = new NativeArray<float4>(60, Allocator.Temp);
            Assert.That(() => job.Validate(2), Throws.Nothing);
        }

        private static ClockTimes Due(float length) => ClockTimes.All(new ClockTime { length = length, count = 1, inUse = true });

        private static void Expect(TestDelegate act, string message) =>
            Assert.That(act, Throws.TypeOf<ArgumentException>().With.Message.StartsWith(message));

        private StepWingsJob Step(ClockTimes clocks) => new StepWingsJob
        {
            clocks = clocks,
            scratch = m_Memory,
            scratchStride = StepScratch.Layout(default, null, out _),
            groups = m_Groups,
            lists = new GroupLists { packList = (int*)m_List.GetUnsafePtr() },
            packs = m_Packs,
        };

        private SkinWingsJob Skin(ClockTimes clocks) =>
            new SkinWingsJob { clocks = clocks, chunks = m_Chunks, targets = m_Targets, packs = m_Packs, bounds = m_Bounds };
    }
}
#endif
