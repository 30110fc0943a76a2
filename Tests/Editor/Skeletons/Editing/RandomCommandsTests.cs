using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = System.Random;

namespace Alate.Editor.Tests
{
    /// <summary>
    /// Random commands on a pair of wings, five thousand in the long tests: whatever comes, counts stay equal and in range, joints stay
    /// finite.
    /// </summary>
    public sealed class RandomCommandsTests : EditingFixture
    {
        private const int k_Commands = 1500, k_ManyCommands = 5000, k_Seed = 20240721;

        private readonly View m_View = View.FromAbove;
        private EditingGroup m_Group;
        private SkeletonPointer m_Pointer;
        private Random m_Random;

        [Test]
        public void RandomCommands_WithAFixedSeed_NeverBreakASkeleton() => Play(k_Seed, k_Commands);

        [Test]
        [Explicit]
        [Category("Long")]
        public void ManyRandomCommands_WithAFixedSeed_NeverBreakASkeleton() => Play(k_Seed, k_ManyCommands);

        [Test]
        [Explicit]
        [Category("Long")]
        public void RandomCommands_WithARandomSeed_NeverBreakASkeleton()
        {
            int seed = Environment.TickCount;
            TestContext.WriteLine($"seed {seed}");
            Play(seed, k_ManyCommands);
        }

        private void Play(int seed, int commands)
        {
            m_Random = new Random(seed);
            m_Group = new EditingGroup(new[] { Editing, Edit(Left) }, Undo);
            m_Pointer = new SkeletonPointer(m_Group, Undo);
            string first = State();
            int changes = 0;
            string before = first;
            for (int k = 0; k < commands; k++)
            {
                string command = Command();
                string fault = Fault(Skeleton) ?? Fault(Left);
                Assert.That(fault, Is.Null, $"seed {seed}, command {k}: {command}");
                Assert.That(Undo.ChangedUnrecorded, Is.False, $"seed {seed}, command {k}: {command}");
                string now = State();
                changes += now != before ? 1 : 0;
                before = now;
            }

            Assert.That(changes, Is.GreaterThan(commands / 10), $"seed {seed}: many commands change something");
            string last = State();
            int steps = Undo.UndoneCount;
            while (Undo.DoneCount > 0)
                Undo.Undo();
            Assert.That(State(), Is.EqualTo(first), $"seed {seed}: all undone");
            while (Undo.UndoneCount > steps)
                Undo.Redo();
            Assert.That(State(), Is.EqualTo(last), $"seed {seed}: all redone");
        }

        private string Command()
        {
            switch (m_Random.Next(16))
            {
                case 0:
                    return Undone();
                case 1:
                    Undo.Redo();
                    return "redo";
                case 2:
                    Editing.IsSymmetric = !Editing.IsSymmetric;
                    return "symmetry";
                case 3:
                case 4:
                    return Chosen();
                case 5:
                case 6:
                    return Dragged();
                case 7:
                    return Moved();
                case 8:
                    return Counted();
                default:
                    EditCommand command = SkeletonCommands.All[m_Random.Next(SkeletonCommands.All.Count)];
                    return $"{command}: {m_Group.Do(command)}";
            }
        }

        private string Undone()
        {
            int steps = 1 + m_Random.Next(5);
            for (int k = 0; k < steps; k++)
                Undo.Undo();
            return $"undo {steps}";
        }

        private string Chosen()
        {
            SkeletonEditing editing = m_Group.All[m_Random.Next(2)];
            var joints = JointPicking.All(editing.Skeleton).Where(joint => m_Random.Next(6) == 0).ToList();
            m_Group.Select(editing, joints, m_Random.Next(3) == 0);
            return $"select {joints.Count}";
        }

        private string Dragged()
        {
            var start = new Vector2(m_Random.Next(-800, 800), m_Random.Next(-500, 500));
            if (m_Group.TryNearest(m_View.Project, start, 1e6f, out SkeletonEditing near, out JointIndex joint) && m_Random.Next(2) == 0)
                start = m_View.Project(near.Skeleton.GetJoint(joint.chain, joint.joint));
            m_Pointer.Press(m_View.Project, start, m_Random.Next(4) == 0, 1 + m_Random.Next(2));
            var mode = (DragMode)m_Random.Next(4);
            for (int k = m_Random.Next(4); k > 0; k--)
            {
                Vector2 pixel = start + new Vector2(m_Random.Next(-300, 300), m_Random.Next(-300, 300));
                m_Pointer.Move(pixel, m_View.Through(pixel), mode);
            }

            if (m_Random.Next(5) == 0)
                m_Pointer.Cancel();
            m_Pointer.Release();
            return $"drag {mode}";
        }

        private string Moved()
        {
            float[] extremes = new[] { float.NaN, float.PositiveInfinity, float.MaxValue, -1e9f, 1e-30f, 0f };
            Vector3 delta = m_Random.Next(4) == 0
                ? Vector3.one * extremes[m_Random.Next(extremes.Length)]
                : new Vector3(Small(), Small(), Small());
            SkeletonEditing editing = m_Group.All[m_Random.Next(2)];
            bool slides = m_Random.Next(2) == 0;
            EditOutcome outcome = editing.Do("Move", (draft, selected) =>
                slides ? SlideCommands.By(draft, selected, delta.x) : MoveCommands.By(draft, selected, delta));
            return $"move {delta} slides {slides}: {outcome}";
        }

        private string Counted()
        {
            int chains = m_Random.Next(0, 20), joints = m_Random.Next(0, 20);
            EditOutcome outcome = Editing.Do("Set Counts", (draft, selected) => ResampleCommands.ToCounts(draft, chains, joints));
            return $"counts {chains} {joints}: {outcome}";
        }

        private float Small() => (float)(m_Random.NextDouble() - 0.5) * 0.1f;

        private static string Fault(WingSkeleton skeleton)
        {
            int chains = skeleton.ChainCount, joints = skeleton.JointsPerChain;
            if (chains < 3 || chains > 16 || joints < 3 || joints > 16)
                return $"{skeleton.name}: {chains} × {joints}";
            foreach (JointChain chain in skeleton.Chains)
            {
                if (chain.Length != joints)
                    return $"{skeleton.name}: a chain of {chain.Length} among chains of {joints}";
                foreach (Vector3 joint in chain.joints)
                {
                    if (!math.all(math.isfinite((float3)joint)))
                        return $"{skeleton.name}: {joint}";
                }
            }

            bool frame = math.all(math.isfinite((float3)skeleton.Hinge)) && math.all(math.isfinite((float3)skeleton.SpanAxis))
                && math.all(math.isfinite((float3)skeleton.UpAxis));
            return frame ? null : $"{skeleton.name}: hinge or axes";
        }

        private string State() => SkeletonText.Of(Skeleton) + "\n" + SkeletonText.Of(Left);
    }
}
