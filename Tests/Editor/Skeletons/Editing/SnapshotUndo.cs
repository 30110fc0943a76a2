using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor.Tests
{
    /// <summary>
    /// Undo and redo by copies of what commands record, with Unity's rules: one step a group, a new step ends what could be redone.
    /// </summary>
    internal sealed class SnapshotUndo : IUndoRecorder
    {
        private readonly Stack<Step> m_Done = new Stack<Step>();
        private readonly Stack<Step> m_Undone = new Stack<Step>();
        private Step m_Open;
        private int m_Depth;

        public int DoneCount => m_Done.Count;

        public int UndoneCount => m_Undone.Count;

        public string LastName => m_Done.Peek().Name;

        /// <summary>True where an object was marked as changed that had not been recorded before.</summary>
        public bool ChangedUnrecorded { get; private set; }

        public void Begin(string command)
        {
            if (m_Depth++ == 0)
                m_Open = new Step(command);
        }

        public void Record(Object target)
        {
            if (m_Open == null)
                throw new InvalidOperationException("Recorded outside a step.");
            m_Open.Keep(target);
        }

        public void Changed(Object target) => ChangedUnrecorded |= m_Open == null || !m_Open.Has(target);

        public void End()
        {
            if (m_Depth == 0 || --m_Depth > 0)
                return;
            if (!m_Open.IsEmpty)
            {
                m_Done.Push(m_Open);
                m_Undone.Clear();
            }

            m_Open = null;
        }

        public void Cancel()
        {
            m_Open?.Swap();
            m_Open = null;
            m_Depth = 0;
        }

        public void Undo() => Turn(m_Done, m_Undone);

        public void Redo() => Turn(m_Undone, m_Done);

        private static void Turn(Stack<Step> from, Stack<Step> to)
        {
            if (from.Count == 0)
                return;
            Step step = from.Pop();
            step.Swap();
            to.Push(step);
        }

        private sealed class Step
        {
            private readonly List<(Object target, Action restore)> m_Kept = new List<(Object, Action)>();

            public Step(string name)
            {
                Name = name;
            }

            public string Name { get; }

            public bool IsEmpty => m_Kept.Count == 0;

            public bool Has(Object target) => m_Kept.Exists(kept => kept.target == target);

            public void Keep(Object target)
            {
                if (!Has(target))
                    m_Kept.Add((target, Restorer(target)));
            }

            // Puts back what was kept, and keeps what was there, for the way back.
            public void Swap()
            {
                for (int k = 0; k < m_Kept.Count; k++)
                {
                    Action back = Restorer(m_Kept[k].target);
                    m_Kept[k].restore();
                    m_Kept[k] = (m_Kept[k].target, back);
                }
            }

            private static Action Restorer(Object target)
            {
                if (target is JointSelection selection)
                {
                    var joints = new List<JointIndex>(selection.Joints);
                    return () => selection.Set(joints);
                }

                var skeleton = (WingSkeleton)target;
                Vector3 hinge = skeleton.Hinge, span = skeleton.SpanAxis, up = skeleton.UpAxis;
                JointChain[] chains = Array.ConvertAll(skeleton.Chains, chain => new JointChain((Vector3[])chain.joints?.Clone()));
                return () =>
                {
                    skeleton.Hinge = hinge;
                    skeleton.SpanAxis = span;
                    skeleton.UpAxis = up;
                    skeleton.Chains = Array.ConvertAll(chains, chain => new JointChain((Vector3[])chain.joints?.Clone()));
                };
            }
        }
    }
}
